#pragma once
/// A study as it was written: checked for its form, not yet for its cases.

#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "scene/case_keys.h"
#include "scene/scene.h"
#include "study/metrics.h"

namespace similitude {

/// One value of a case that a study changes.
struct Setting {
  std::string path;   // "models.drag"
  std::string value;  // as for --set: "{id: link, n: 1.5}"
  std::string label;  // for names: "link_n_1.5"
  SourceMark mark;
  std::string written_at;  // path in the study file: "axes.models.drag"
  std::string assignment() const { return path + "=" + value; }
};

struct StudyAxis {
  std::string path;
  std::vector<Setting> values;
};

struct NamedCase {
  std::string name;
  SourceMark mark;
  std::vector<Setting> settings;
};

enum class ReferenceKind { one_of_the_cases, stored_run, measured_data };

struct StudyReference {
  ReferenceKind kind = ReferenceKind::one_of_the_cases;
  std::string name;            // of the case
  std::filesystem::path path;  // of the run's folder or the data's file, absolute
  std::string path_as_written;
  SourceMark mark;
};

struct StudyFile {
  std::string title, name;           // name: the file's stem
  std::filesystem::path file, base;  // absolute base
  std::vector<Setting> set;          // for all cases
  std::vector<StudyAxis> axes;
  std::vector<NamedCase> cases;
  StudyReference reference;
  std::vector<const Metric*> metrics;  // the first is the frontier's
  SourceMark metrics_mark;
  std::optional<double> from;            // [s]
  std::optional<std::string> smoothing;  // as written: goes to --set
  SourceMark smoothing_mark, from_mark;
  std::string from_text;
  int repeats = 3;
  double short_run = 0;  // [s] of wall time: shorter runs are repeated
  double leg = 0;        // [s] of the real bed: runs made elsewhere go on so long to be timed here; 0: not
  int threads = 0;       // 0: all cores
};

/// The version of the format, the value of the key `similitude_study`.
inline constexpr int k_study_version = 1;

KeyTable study_keys();
KeyTable study_case_keys();
KeyTable study_run_reference_keys();
KeyTable study_data_reference_keys();

/// Throws InputError with file, line and column.
StudyFile read_study(const std::filesystem::path& file);

}  // namespace similitude
