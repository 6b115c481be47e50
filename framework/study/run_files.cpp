#include "study/run_files.h"

#include <algorithm>
#include <cmath>
#include <fstream>
#include <nlohmann/json.hpp>

#include "scene/messages.h"
#include "scene/section.h"
#include "scene/units.h"
#include "output/csv_table.h"
#include "study/metrics.h"

namespace similitude {
namespace {

using json = nlohmann::json;
namespace fs = std::filesystem;

json read_json(const fs::path& file) {
  std::ifstream stream(file);
  const json page = stream.is_open() ? json::parse(stream, nullptr, false) : json(json::value_t::discarded);
  if (page.is_discarded())
    throw InputError(file.string() + (stream.is_open() ? ": this is not JSON." : ": there is no such file."),
                     "Is this the folder of a run? Its run must have ended.");
  return page;
}

/// Reads a page as a run writes it; another shape is told, not crashed on.
template <class Read>
auto as_written(const fs::path& file, Read read) {
  const json page = read_json(file);
  const InputError another(file.string() + ": this file is not as a run writes it.", "Was it written by another version?");
  try {
    return read(page);
  } catch (const json::exception&) {
    throw another;
  } catch (const QuantityError&) {
    throw another;
  }
}

Profile& profile_named(std::vector<Profile>& profiles, const std::string& sampler) {
  for (Profile& profile : profiles)
    if (profile.sampler == sampler) return profile;
  profiles.push_back({.sampler = sampler, .bins = {}});
  return profiles.back();
}

std::vector<Profile> read_profiles(const fs::path& folder) {
  std::vector<Profile> profiles;
  const CsvTable table(folder / "profiles.csv");
  const auto samplers = table.texts("sampler");
  const auto x = table.numbers("x"), z = table.numbers("z"), mean = table.numbers("mean");
  const auto error = table.numbers("standard error"), blocks = table.numbers("blocks");
  for (std::size_t k = 0; k < table.rows(); ++k)
    profile_named(profiles, samplers[k])
        .bins.push_back(
            {.x = x[k], .z = z[k], .mean = mean[k], .standard_error = error[k], .blocks = blocks[k], .in_blocks = {}});

  const fs::path file = folder / "profile_blocks.csv";
  if (!fs::exists(file)) return profiles;
  const CsvTable in_blocks(file);
  const auto of = in_blocks.texts("sampler");
  const auto bx = in_blocks.numbers("x"), bz = in_blocks.numbers("z");
  const auto sum = in_blocks.numbers("weighted sum"), weight = in_blocks.numbers("weight");
  for (std::size_t k = 0; k < in_blocks.rows(); ++k)
    for (ProfileBin& bin : profile_named(profiles, of[k]).bins)
      if (bin.x == bx[k] && bin.z == bz[k]) bin.in_blocks.push_back({sum[k], weight[k]});
  return profiles;
}

}  // namespace

const Profile* Observations::profile(const std::string& sampler) const {
  for (const Profile& one : profiles)
    if (one.sampler == sampler) return &one;
  return nullptr;
}

bool has_manifest(const fs::path& folder) { return fs::is_regular_file(folder / "manifest.json"); }

RunManifest read_manifest(const fs::path& folder) {
  return as_written(folder / "manifest.json", [](const json& page) {
    RunManifest manifest;
    manifest.status = page.at("status").get<std::string>();
    manifest.exit_reason = page.at("exit_reason").get<std::string>();
    if (page.at("state_hash").is_string()) manifest.state_hash = page.at("state_hash").get<std::string>();
    manifest.particles = page.at("particles").get<std::int64_t>();
    manifest.identity.resolved_case = page.at("case").dump(2);
    if (const auto bed = page.find("bed_sha256"); bed != page.end() && bed->is_string())   // older runs do not tell
      manifest.identity.bed_sha256 = bed->get<std::string>();
    manifest.simulated_s = page.at("simulated_s").get<double>();
    manifest.end = parse_quantity(page.at("case").at("time").at("end").get<std::string>(), "s");
    manifest.machine.processor = page.at("machine").at("processor").get<std::string>();
    manifest.machine.cores = page.at("machine").at("cores").get<int>();
    manifest.machine.kernel = page.at("machine").at("kernel").get<std::string>();
    manifest.threads = page.at("threads").get<int>();
    manifest.at_one_go = page.at("resumed").empty();
    return manifest;
  });
}

RunTiming read_timing(const fs::path& folder) { return read_timing_file(folder / "timing.json"); }

RunTiming read_timing_file(const fs::path& file) {
  return as_written(file, [](const json& page) {
    RunTiming timing;
    timing.wall_s = page.at("wall_s").get<double>();
    timing.simulated_s = page.at("simulated_s").get<double>();
    timing.particle_steps = page.at("particle_steps").get<double>();
    timing.particle_steps_per_s = page.at("particle_steps_per_s").get<double>();
    for (const json& stage : page.at("stages"))
      timing.stages.push_back(
          {stage.at("name").get<std::string>(), stage.at("seconds").get<double>(), stage.at("share").get<double>()});
    return timing;
  });
}

Observations read_observations(const fs::path& folder, double from) {
  Observations seen;
  const CsvTable monitors(folder / "monitors.csv");
  const std::vector<double> times = monitors.numbers("time [s]");
  for (const Metric& metric : all_metrics()) {
    if (metric.of_profile() || !monitors.has(metric.source)) continue;
    const std::vector<double> values = monitors.numbers(metric.source);
    seen.monitors[metric.source] = even_series(times, values, from);
    double largest = Estimate::k_unknown;
    for (const double value : values)
      if (!std::isnan(value)) largest = std::isnan(largest) ? std::abs(value) : std::max(largest, std::abs(value));
    seen.largest[metric.source] = largest;
  }
  if (fs::exists(folder / "profiles.csv")) seen.profiles = read_profiles(folder);
  return seen;
}

Observations read_measured(const fs::path& file) {
  const CsvTable table(file);
  for (const char* column : {"sampler", "x", "z", "mean"})
    if (!table.has(column))
      throw InputError(
          file.string() +
              ": measured data need the columns sampler, x, z, mean and, if known, standard error, but these are " +
              listed(table.columns()) + ".",
          "Name them in the first row. x and z in metres; sampler as in profiles.csv of a run, e.g. vertical_velocity "
          "[m/s].");
  const auto samplers = table.texts("sampler");
  const auto x = table.numbers("x"), z = table.numbers("z"), mean = table.numbers("mean");
  const auto error = table.has("standard error") ? table.numbers("standard error")
                                                 : std::vector<double>(mean.size(), Estimate::k_unknown);
  std::vector<std::string> known;
  for (const Metric& metric : all_metrics())
    if (const std::string name = metric.of_profile() ? metric.source : metric.name;
        metric.can_be_measured() && std::find(known.begin(), known.end(), name) == known.end())
      known.push_back(name);

  Observations seen;
  for (std::size_t k = 0; k < table.rows(); ++k) {
    const std::string where = file.string() + ":" + std::to_string(k + 2) + ": ";
    if (std::find(known.begin(), known.end(), samplers[k]) == known.end())
      throw InputError(where + "there is nothing called \"" + samplers[k] + "\" to compare with.",
                       did_you_mean(samplers[k], known) + "Known: " + listed(known) + ".");
    if (std::isnan(mean[k])) throw InputError(where + "this row has no mean.", "Remove the row.");
    const Metric* single = find_metric(samplers[k]);
    if (single == nullptr && (std::isnan(x[k]) || std::isnan(z[k])))
      throw InputError(where + "a point of a profile needs x and z.", "Both in metres.");
    if (single != nullptr) {
      // Of a measured mean the standard error is taken as known: 1.96 of it make 95 %.
      const double reach = std::isnan(error[k]) ? 0 : student_two_sided(0.95, 1e6) * error[k];
      Estimate& given = seen.given[samplers[k]] = exactly(mean[k]);
      given.low -= reach;
      given.high += reach;
      continue;
    }
    Profile& profile = profile_named(seen.profiles, samplers[k]);
    profile.measured = true;
    profile.bins.push_back(
        {.x = x[k], .z = z[k], .mean = mean[k], .standard_error = error[k], .blocks = 0, .in_blocks = {}});
  }
  return seen;
}

}  // namespace similitude
