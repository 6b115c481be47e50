#include "study/study_plan.h"

#include <algorithm>
#include <cmath>
#include <nlohmann/json.hpp>

#include "coupling/coupling.h"
#include "scene/case_file.h"
#include "scene/document.h"
#include "scene/messages.h"
#include "scene/section.h"
#include "scene/units.h"
#include "stepper/assembly.h"
#include "stepper/resume.h"
#include "stepper/time_steps.h"
#include "study/case_matrix.h"

namespace similitude {
namespace {

constexpr const char* k_smoothing_path = "coupling.smoothing";
constexpr double k_same_place = 1e-6;  // relative, of heights

/// Does the case, as it is or as it is set, average profiles? Only then can it be told from when.
bool averages_profiles(const StudyFile& study, const std::vector<Setting>& settings) {
  const std::string path = "output.profiles";
  for (const Setting& setting : settings)
    if (setting.path.starts_with(path)) return true;
  const Document base(study.base);
  const DocumentNode* output = base.root().find("output");
  return output != nullptr && output->find("profiles") != nullptr;
}

/// What all cases set and what this one sets; the later win.
std::vector<Setting> settings_of(const StudyFile& study, const NamedCase& one) {
  std::vector<Setting> all = study.set;
  if (study.smoothing) all.push_back({k_smoothing_path, *study.smoothing, "", study.smoothing_mark, "smoothing"});
  all.insert(all.end(), one.settings.begin(), one.settings.end());
  if (study.from && averages_profiles(study, all))
    all.push_back({"output.profiles.from", study.from_text, "", study.from_mark, "from"});
  return all;
}

/// What a message about "--set: path: …" says in the study's own terms: the place where the value was written.
template <class Error>
[[noreturn]] void tell_in_terms_of_study(const Error& error, const std::vector<Setting>& settings,
                                         const std::string& name) {
  const std::string text = error.what(), mark = "--set: ";
  const std::string path =
      text.starts_with(mark) ? text.substr(mark.size(), text.find(": ", mark.size()) - mark.size()) : "";
  const Setting* meant = nullptr;
  for (const Setting& setting : settings)
    if (path == setting.path || path.starts_with(setting.path + ".") || setting.path.starts_with(path + "."))
      meant = &setting;
  if (meant == nullptr || path.empty()) throw Error(text + "\n  This is about the case " + name + " of the study.");
  const std::string rest = path.starts_with(meant->path) ? path.substr(meant->path.size()) : "";
  const std::string what = text.substr(mark.size() + path.size() + 2);
  throw Error(InputError(meant->mark, meant->written_at + rest, what).what());
}

struct ReadCase {
  CaseFile file;
  double default_smoothing = 0;  // [m] of the real bed
  double dt = 0;                 // [s] of the real bed
};

ReadCase read_and_assemble(const StudyFile& study, const Catalogue& catalogue, const std::vector<Setting>& settings,
                           const std::string& name, std::vector<std::string>& warnings) {
  std::vector<std::string> overrides;
  for (const Setting& setting : settings) overrides.push_back(setting.assignment());
  try {
    ReadCase read{.file = read_case(study.base, catalogue, overrides)};
    const Assembly assembly = assemble(read.file.scene, catalogue);
    const TimeSteps steps = choose_time_steps(assembly);
    read.default_smoothing = smoothing_length_of(assembly.model) / assembly.results.length;
    read.dt = steps.dt / assembly.results.time;
    for (const auto& list : {read.file.warnings, assembly.warnings, steps.warnings})
      for (const std::string& warning : list)
        if (std::find(warnings.begin(), warnings.end(), warning) == warnings.end()) warnings.push_back(warning);
    return read;
  } catch (const InputError& error) {
    tell_in_terms_of_study(error, settings, name);
  } catch (const PluginError& error) {
    tell_in_terms_of_study(error, settings, name);
  }
}

bool sets(const std::vector<Setting>& settings, const std::string& path) {
  return std::any_of(settings.begin(), settings.end(), [&](const Setting& s) { return s.path == path; });
}

bool any_profile_metric(const StudyFile& study) {
  return std::any_of(study.metrics.begin(), study.metrics.end(), [](const Metric* m) { return m->of_profile(); });
}

void check_window(const StudyFile& study, const PlannedCase& planned) {
  if (planned.from < planned.end) return;
  throw InputError(study.from ? study.from_mark : study.metrics_mark, study.from ? "from" : "metrics",
                   "averages would start at " + format_quantity(planned.from, "s") + ", but the case " + planned.name +
                       " ends at " + format_quantity(planned.end, "s") + ".",
                   "Start earlier (from), or run longer (set: {time.end: …}).");
}

void check_heights(const StudyFile& study, const PlannedCase& planned, const RealScene& scene) {
  if (!any_profile_metric(study)) return;
  if (scene.output.profiles.z.empty())
    throw InputError(study.metrics_mark, "metrics",
                     "profiles are compared at heights, but the case " + planned.name + " has none.",
                     "Add for example set: {output.profiles.z: [50 mm]}.");
  for (const double z : scene.output.profiles.z)
    if (z > scene.size[2])
      throw InputError(study.metrics_mark, "metrics",
                       "profiles are compared at the height " + format_quantity(z, "mm") +
                           ", which is outside the bed of " + format_quantity(scene.size[2], "mm") + " of the case " +
                           planned.name + ".",
                       "Change output.profiles.z.");
}

std::size_t find_reference(const StudyFile& study, const std::vector<PlannedCase>& cases) {
  std::vector<std::string> names;
  for (std::size_t k = 0; k < cases.size(); ++k) {
    if (cases[k].name == study.reference.name) return k;
    names.push_back(cases[k].name);
  }
  throw InputError(study.reference.mark, "reference", "there is no case \"" + study.reference.name + "\".",
                   did_you_mean(study.reference.name, names) + "Cases: " + listed(names) +
                       ".\nA finished run is named by {run: folder}, measured data by {data: file}.");
}

bool has_height(const std::vector<double>& heights, double z) {
  return std::any_of(heights.begin(), heights.end(),
                     [&](double h) { return std::abs(h - z) <= k_same_place * std::abs(z); });
}

void check_stored_heights(const StudyPlan& plan, const std::vector<double>& heights) {
  for (const Metric* metric : plan.study.metrics) {
    if (!metric->of_profile()) continue;
    const Profile* profile = plan.outside->profile(metric->source);
    std::vector<double> stored;
    if (profile != nullptr)
      for (const ProfileBin& bin : profile->bins) stored.push_back(bin.z);
    for (const double z : heights)
      if (!has_height(stored, z))
        throw InputError(plan.study.reference.mark, "reference",
                         "the run in " + plan.study.reference.path_as_written + " has no " + metric->source +
                             " at the height " + format_quantity(z, "mm") + ".",
                         "Compare at its heights (output.profiles.z), or run it again with this one.");
  }
}

void check_measured(const StudyPlan& plan, const std::vector<double>& heights) {
  for (const Metric* metric : plan.study.metrics) {
    if (metric->kind == MetricKind::residual) continue;
    const Profile* profile = metric->of_profile() ? plan.outside->profile(metric->source) : nullptr;
    if (profile == nullptr && !plan.outside->given.contains(metric->name))
      throw InputError(plan.study.reference.mark, "reference.data",
                       "the measured data hold nothing for the metric " + std::string(metric->name) + ".",
                       std::string("Add rows with the sampler ") +
                           (metric->of_profile() ? metric->source : metric->name) +
                           ", or take the metric off the list.");
    if (profile == nullptr) continue;
    for (const ProfileBin& bin : profile->bins)
      if (!has_height(heights, bin.z))
        throw InputError(plan.study.reference.mark, "reference.data",
                         "the data hold " + std::string(metric->source) + " at the height " +
                             format_quantity(bin.z, "mm") + ", where the cases have no profile.",
                         "Add this height to output.profiles.z.");
  }
}

/// Of the case in a manifest; NaN if it averages no profiles.
double profiles_from(const std::string& resolved) {
  const nlohmann::json page = nlohmann::json::parse(resolved, nullptr, false);
  const nlohmann::json::json_pointer at("/output/profiles/from");
  if (page.is_discarded() || !page.contains(at) || !page.at(at).is_string()) return std::nan("");
  return parse_quantity(page.at(at).get<std::string>(), "s");
}

void read_stored_run(StudyPlan& plan, const std::vector<double>& heights) {
  const StudyReference& reference = plan.study.reference;
  if (!has_manifest(reference.path))
    throw InputError(
        reference.mark, "reference.run", "there is no run in " + reference.path.string() + ".",
        "A relative path starts at the study's folder. Run the reference first: similitude run CASE -o FOLDER.");
  plan.stored = read_manifest(reference.path);
  if (!plan.stored->done())
    throw InputError(reference.mark, "reference.run",
                     "the run in " + reference.path_as_written + " did not finish: it is " + plan.stored->status +
                         (plan.stored->exit_reason.empty() ? "" : " (" + plan.stored->exit_reason + ")") + ".",
                     "Run it to its end, or take another reference.");
  const double from = plan.cases.front().from;
  plan.outside = read_observations(reference.path, from);
  if (const double stored_from = profiles_from(plan.stored->identity.resolved_case);
      std::abs(stored_from - from) > k_same_place * from)
    plan.warnings.push_back("the profiles of " + reference.path_as_written + " are averaged from " +
                            format_quantity(stored_from, "s") + " on, those of the cases from " +
                            format_quantity(from, "s") + ".");
  check_stored_heights(plan, heights);
}

}  // namespace

std::string StudyPlan::reference_name() const {
  if (reference_case) return cases[*reference_case].name;
  return study.reference.path.has_filename() ? study.reference.path.filename().string()
                                             : study.reference.path.parent_path().filename().string();
}

StudyPlan plan_study(const StudyFile& study, const Catalogue& catalogue) {
  StudyPlan plan;
  plan.study = study;
  std::vector<NamedCase> named = cases_of(study);
  std::vector<std::string> ignored;

  bool left_to_default = !study.smoothing && !sets(study.set, k_smoothing_path);
  double largest = 0;
  std::vector<ReadCase> read;
  for (const NamedCase& one : named) {
    const std::vector<Setting> settings = settings_of(study, one);
    read.push_back(read_and_assemble(study, catalogue, settings, one.name, plan.warnings));
    left_to_default = left_to_default && !read.back().file.scene.smoothing_length;
    largest = std::max(largest, read.back().default_smoothing);
  }
  std::vector<Setting> chosen;  // by the study: what no single case could say
  if (left_to_default) {
    Setting& smoothing = chosen.emplace_back();
    smoothing.path = k_smoothing_path;
    smoothing.value = exact_number(largest) + " m";
    smoothing.written_at = "smoothing";
  }

  for (std::size_t k = 0; k < named.size(); ++k) {
    PlannedCase planned;
    planned.name = named[k].name;
    planned.settings = named[k].settings;
    std::vector<Setting> settings = chosen;
    for (const Setting& setting : settings_of(study, named[k])) settings.push_back(setting);
    for (const Setting& setting : settings) planned.overrides.push_back(setting.assignment());
    if (left_to_default) read[k] = read_and_assemble(study, catalogue, settings, planned.name, ignored);
    const RealScene& scene = read[k].file.scene;
    planned.identity = identity_of(read[k].file);
    planned.from = study.from.value_or(scene.output.profiles.from);
    planned.end = scene.time.end;
    planned.dt = read[k].dt;
    planned.cell = scene.cell[0];
    check_window(study, planned);
    check_heights(study, planned, scene);
    plan.cases.push_back(std::move(planned));
  }
  bool one_length = true;
  for (const ReadCase& one : read)
    one_length = one_length && one.file.scene.smoothing_length == read.front().file.scene.smoothing_length;
  if (one_length) plan.smoothing = read.front().file.scene.smoothing_length;

  const std::vector<double>& heights = read.front().file.scene.output.profiles.z;
  switch (study.reference.kind) {
    case ReferenceKind::one_of_the_cases:
      plan.reference_case = find_reference(study, plan.cases);
      break;
    case ReferenceKind::stored_run:
      read_stored_run(plan, heights);
      break;
    case ReferenceKind::measured_data:
      plan.outside = read_measured(study.reference.path);
      check_measured(plan, heights);
      break;
  }
  return plan;
}

}  // namespace similitude
