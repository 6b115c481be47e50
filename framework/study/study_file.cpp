#include "study/study_file.h"

#include <algorithm>
#include <array>

#include "scene/document.h"
#include "scene/messages.h"
#include "scene/section.h"

namespace similitude {

KeyTable study_keys() {
  static constexpr std::array keys{
      CaseKey{
          .name = "similitude_study", .form = Form::integer, .required = true, .doc = "version of the study format: 1"},
      CaseKey{.name = "title", .form = Form::text, .doc = "one line for reports; the file's name if left out"},
      CaseKey{.name = "base",
              .form = Form::text,
              .required = true,
              .doc = "the case file that all cases start from, from the study's folder"},
      CaseKey{.name = "set", .form = Form::text, .doc = "case paths and values for all cases, as with --set"},
      CaseKey{.name = "axes",
              .form = Form::text,
              .doc = "case paths, each with a list of values; every combination is a case"},
      CaseKey{.name = "cases",
              .form = Form::text,
              .doc = "instead of axes: a list of cases, each with a name and what it sets"},
      CaseKey{.name = "reference",
              .form = Form::text,
              .required = true,
              .doc = "a case's name, {run: folder} or {data: file}"},
      CaseKey{.name = "metrics",
              .form = Form::texts,
              .required = true,
              .doc = "what is compared; the first is the frontier's"},
      CaseKey{.name = "from",
              .form = Form::quantity,
              .unit = "s",
              .sign = Sign::not_negative,
              .doc = "start of all averages; the case's output.profiles.from if left out"},
      CaseKey{.name = "smoothing",
              .form = Form::quantity,
              .unit = "mm",
              .sign = Sign::positive,
              .doc = "one coupling.smoothing for all cases; the largest of their defaults if left out"},
      CaseKey{.name = "repeats",
              .form = Form::integer,
              .sign = Sign::positive,
              .default_text = "3",
              .doc = "how often a short run is timed; the median counts"},
      CaseKey{.name = "short",
              .form = Form::quantity,
              .unit = "s",
              .sign = Sign::not_negative,
              .default_text = "10 s",
              .doc = "wall time below which a run is repeated"},
      CaseKey{.name = "leg",
              .form = Form::quantity,
              .unit = "s",
              .sign = Sign::positive,
              .doc = "runs made elsewhere, the stored reference among them, go on for so long to know their speed on this machine"},
      CaseKey{.name = "threads",
              .form = Form::integer,
              .sign = Sign::positive,
              .doc = "threads of each run; all cores if left out"},
  };
  return keys;
}

KeyTable study_case_keys() {
  static constexpr std::array keys{
      CaseKey{.name = "name", .form = Form::text, .required = true, .doc = "letters, digits and . _ + -"},
      CaseKey{.name = "set", .form = Form::text, .doc = "case paths and values, as with --set"},
  };
  return keys;
}

KeyTable study_run_reference_keys() {
  static constexpr std::array keys{
      CaseKey{.name = "run",
              .form = Form::text,
              .required = true,
              .doc = "folder of a finished run, from the study's folder"},
  };
  return keys;
}

KeyTable study_data_reference_keys() {
  static constexpr std::array keys{
      CaseKey{
          .name = "data", .form = Form::text, .required = true, .doc = "CSV of measured data, from the study's folder"},
  };
  return keys;
}

namespace {

constexpr const char* k_name_letters = "abcdefghijklmnopqrstuvwxyzABCDEFGHIJKLMNOPQRSTUVWXYZ0123456789._+-";

std::string quoted_if_needed(const std::string& text) {
  const bool plain = !text.empty() && text.find_first_of(",[]{}:#&*!|>'\"%@`\n\\=") == std::string::npos &&
                     text.front() != ' ' && text.back() != ' ' && text.front() != '-' && text.front() != '?';
  const bool number = !text.empty() && text.find_first_not_of("0123456789+-.eE") == std::string::npos;
  if (plain || number) return text;
  std::string quoted = "\"";
  for (const char c : text)
    quoted += c == '"' || c == '\\' ? std::string{'\\', c} : c == '\n' ? "\\n" : std::string(1, c);
  return quoted + "\"";
}

/// A value of the file as one line of YAML.
std::string one_line(const DocumentNode& node) {
  std::string text;
  if (node.is_scalar()) return quoted_if_needed(node.text);
  for (std::size_t k = 0; k < node.items.size(); ++k)
    text += (k == 0 ? "" : ", ") + (node.is_map() ? quoted_if_needed(node.keys[k].name) + ": " : "") +
            one_line(node.items[k]);
  if (node.is_map()) return "{" + text + "}";
  return node.is_list() ? "[" + text + "]" : "";
}

/// Letters that a folder's name may hold: "{id: link, n: 1.5}" is link_n_1.5.
std::string label_of(const DocumentNode& node) {
  std::string text;
  if (node.is_scalar()) {
    for (const char c : node.text)
      if (c != ' ') text += std::string(k_name_letters).find(c) == std::string::npos ? '_' : c;
    return text;
  }
  for (std::size_t k = 0; k < node.items.size(); ++k) {
    const bool named = node.is_map() && node.keys[k].name != "id";
    text += (text.empty() ? "" : "_") + (named ? node.keys[k].name + "_" : "") + label_of(node.items[k]);
  }
  return text.empty() ? "none" : text;
}

Setting setting_of(const std::string& path, const DocumentNode& value, const std::string& written_at) {
  return {path, one_line(value), label_of(value), value.mark, written_at};
}

std::vector<Setting> read_settings(const DocumentNode* node, const std::string& at) {
  std::vector<Setting> settings;
  if (node == nullptr) return settings;
  if (!node->is_map())
    throw InputError(node->mark, at, "a map of case paths and values is needed, but this is " + node->described() + ".",
                     "Write for example " + at.substr(at.rfind('.') + 1) + ": {models.drag: gidaspow, time.end: 1 s}.");
  for (std::size_t k = 0; k < node->keys.size(); ++k)
    settings.push_back(setting_of(node->keys[k].name, node->items[k], at + "." + node->keys[k].name));
  return settings;
}

std::vector<StudyAxis> read_axes(const DocumentNode* node) {
  std::vector<StudyAxis> axes;
  if (node == nullptr) return axes;
  const std::string sample = "Write for example axes: {models.drag: [gidaspow, di_felice]}.";
  if (!node->is_map())
    throw InputError(node->mark, "axes", "a map of case paths is needed, but this is " + node->described() + ".",
                     sample);
  for (std::size_t k = 0; k < node->keys.size(); ++k) {
    const std::string& path = node->keys[k].name;
    const DocumentNode& values = node->items[k];
    if (!values.is_list() || values.items.empty())
      throw InputError(
          values.mark, "axes." + path,
          "a list of values is needed, but this is " + (values.is_list() ? "an empty one" : values.described()) + ".",
          sample);
    StudyAxis axis{.path = path, .values = {}};
    for (const DocumentNode& value : values.items) axis.values.push_back(setting_of(path, value, "axes." + path));
    axes.push_back(std::move(axis));
  }
  return axes;
}

std::vector<NamedCase> read_cases(const DocumentNode* node) {
  std::vector<NamedCase> cases;
  if (node == nullptr) return cases;
  if (!node->is_list())
    throw InputError(node->mark, "cases", "a list of cases is needed, but this is " + node->described() + ".",
                     "Write for example\ncases:\n  - {name: coarse, set: {scene.domain.cell: 5 mm}}");
  for (const DocumentNode& item : node->items) {
    const std::string at = "cases." + std::to_string(cases.size());
    const Section section(&item, at, study_case_keys(), item.mark);
    NamedCase one{.name = section.text("name"),
                  .mark = section.mark("name"),
                  .settings = read_settings(section.node("set"), at + ".set")};
    if (one.name.empty() || one.name.front() == '.' || one.name.find_first_not_of(k_name_letters) != std::string::npos)
      throw InputError(one.mark, at + ".name", "\"" + one.name + "\" cannot be the name of a folder of results.",
                       "Use letters, digits and . _ + -, and no dot in front.");
    for (const NamedCase& other : cases)
      if (other.name == one.name)
        throw InputError(one.mark, at + ".name", one.name + " is the name of two cases.", "Rename one of them.");
    cases.push_back(std::move(one));
  }
  return cases;
}

StudyReference read_reference(const DocumentNode& node, const std::filesystem::path& folder) {
  StudyReference reference;
  reference.mark = node.mark;
  if (node.is_scalar()) {
    reference.name = node.text;
    return reference;
  }
  const bool data = node.find("data") != nullptr;
  if (!node.is_map() || (!data && node.find("run") == nullptr))
    throw InputError(node.mark, "reference", node.described() + " says nothing to compare with.",
                     "Write the name of a case, {run: folder of a finished run} or {data: file of measured data}.");
  const Section section(&node, "reference", data ? study_data_reference_keys() : study_run_reference_keys(), node.mark);
  reference.kind = data ? ReferenceKind::measured_data : ReferenceKind::stored_run;
  reference.path_as_written = section.text(data ? "data" : "run");
  reference.path = (folder / reference.path_as_written).lexically_normal();
  return reference;
}

std::vector<const Metric*> read_metrics(const Section& root) {
  std::vector<std::string> known;
  for (const Metric& metric : all_metrics()) known.emplace_back(metric.name);
  std::vector<const Metric*> metrics;
  for (const std::string& name : root.texts("metrics")) {
    const DocumentNode& item = root.node("metrics")->items[metrics.size()];
    const std::string at = "metrics." + std::to_string(metrics.size());
    const Metric* metric = find_metric(name);
    if (metric == nullptr)
      throw InputError(item.mark, at, "there is no metric \"" + name + "\".",
                       did_you_mean(name, known) + "Metrics: " + listed(known) + ".");
    if (std::find(metrics.begin(), metrics.end(), metric) != metrics.end())
      throw InputError(item.mark, at, name + " is in the list twice.", "Keep one of the two.");
    metrics.push_back(metric);
  }
  if (metrics.empty())
    throw InputError(root.mark("metrics"), "metrics", "this list is empty.", "Metrics: " + listed(known) + ".");
  return metrics;
}

/// Before the section's own check, whose words are those of a case file.
void check_head(const Document& document) {
  const DocumentNode* version = document.root().find("similitude_study");
  const std::string wanted = std::to_string(k_study_version);
  if (version == nullptr)
    throw InputError(document.root().mark, "similitude_study",
                     "this key is missing: it says for which version of the format a study is written.",
                     document.root().find("similitude") != nullptr
                         ? "This looks like a case file: similitude run runs it."
                         : "Start the file with the line similitude_study: " + wanted + ".");
  if (!version->is_text(wanted.c_str()))
    throw InputError(version->mark, "similitude_study",
                     version->described() + " is no version of the format that this program knows.",
                     "Write similitude_study: " + wanted + ", or use a program made for that version.");
  std::vector<std::string> known;
  for (const CaseKey& key : study_keys()) known.emplace_back(key.name);
  for (const DocumentNode::Key& key : document.root().keys)
    if (std::find(known.begin(), known.end(), key.name) == known.end())
      throw InputError(key.mark, key.name, "there is no such key.",
                       did_you_mean(key.name, known) + "Keys of a study: " + listed(known) + ".");
}

}  // namespace

StudyFile read_study(const std::filesystem::path& file) {
  const Document document(file, "similitude_study");
  check_head(document);
  const Section root(&document.root(), "", study_keys(), document.root().mark);
  const std::filesystem::path folder = std::filesystem::absolute(file).lexically_normal().parent_path();

  StudyFile study;
  study.file = file;
  study.name = file.stem().string();
  study.title = root.given("title") ? root.text("title") : study.name;
  study.base = (folder / root.text("base")).lexically_normal();
  if (!std::filesystem::is_regular_file(study.base))
    throw InputError(root.mark("base"), "base", "there is no case file " + study.base.string() + ".",
                     "A relative path starts at the study's folder.");
  study.set = read_settings(root.node("set"), "set");
  study.axes = read_axes(root.node("axes"));
  study.cases = read_cases(root.node("cases"));
  if (study.axes.empty() == study.cases.empty())
    throw InputError(
        root.mark(study.axes.empty() ? "" : "cases"), study.axes.empty() ? "" : "cases",
        study.axes.empty() ? "there are no cases: neither axes nor cases is given." : "axes and cases are both given.",
        study.axes.empty() ? "Add for example axes: {models.drag: [gidaspow, di_felice]}."
                           : "Keep one of the two; a case may set several values.");
  study.reference = read_reference(*root.node("reference"), folder);
  study.metrics = read_metrics(root);
  study.metrics_mark = root.mark("metrics");
  if (root.given("from")) {
    study.from = root.quantity("from");
    study.from_text = root.node("from")->text;
    study.from_mark = root.mark("from");
  }
  if (root.given("smoothing")) {
    root.quantity("smoothing");
    study.smoothing = root.node("smoothing")->text;
    study.smoothing_mark = root.mark("smoothing");
  }
  study.repeats = static_cast<int>(std::min<std::int64_t>(root.integer("repeats"), 100));
  study.short_run = root.quantity("short");
  if (root.given("leg")) study.leg = root.quantity("leg");
  if (root.given("threads")) study.threads = static_cast<int>(root.integer("threads"));
  return study;
}

}  // namespace similitude
