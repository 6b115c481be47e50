#pragma once
/// manifest.json: all that is needed to say what made these results, and to make them again.

#include <similitude/abi.h>

#include <string>
#include <vector>

#include "loader/catalogue.h"
#include "output/directory.h"
#include "output/map_back.h"
#include "scene/scene.h"

namespace similitude {

struct ManifestPlugin {
  std::string kind, id, version;
  std::string file, sha256;
};
/// Reads the plugin's file for its hash.
ManifestPlugin manifest_plugin(const PluginEntry& plugin);

/// One start of the program in a run's life after the first.
struct Resumption {
  std::string checkpoint;  // file
  double simulated_s = 0;  // [s] of the real bed, where it went on
  std::string started;     // UTC
  std::string command;
  int threads = 1;
};

/// Which case a run is of.
struct CaseIdentity {
  std::string resolved_case;  // CaseFile::resolved: JSON text of a case file with every default filled in
  std::string bed_sha256;     // of the bed's file; "" without one, or where an earlier run does not tell
};

struct Machine {
  std::string processor, kernel;
  int cores = 0;
};
Machine this_machine();

struct Manifest {
  std::string program_version;  // "1.0.0"
  std::string command;          // as typed
  std::string case_file;        // as it was read, absolute
  std::vector<ManifestPlugin> plugins;
  Machine machine;
  int threads = 1;
  similitude_ratios scaling{};  // as the law returned them
  MapBack map_back;
  std::uint64_t particles = 0;     // simulated, at the start
  std::vector<Resumption> resumed;
  std::string started, ended;      // UTC, ISO 8601; `ended` empty while running
  std::string status = "running";  // "running", "done", "stopped", "interrupted", "failed"
  int exit_status = -1;            // of the process; -1 while running, and of a run that failed
  std::string exit_reason;         // in words: "reached the end time", a guard's message, …
  double simulated_s = 0;          // [s], of the real bed, reached
  std::string state_hash;          // "" while running
};

/// "2026-03-01T12:00:00Z"
std::string utc_now();

/// Replaces manifest.json as a whole; called at the start and at the end. The resolved case is kept under "case". Throws
/// OutputError.
void write_manifest(const OutputDirectory& directory, const Manifest& manifest, const CaseIdentity& identity);

}  // namespace similitude
