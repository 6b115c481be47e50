#pragma once
/// One case from its file to its folder of results.

#include <filesystem>
#include <optional>
#include <ostream>
#include <string>

#include "loader/catalogue.h"
#include "scene/case_file.h"

namespace similitude {

struct RunOptions {
  std::filesystem::path folder;           // empty: results/<case name>
  bool force = false;
  bool resume = false;                    // go on from the newest checkpoint in the folder
  std::optional<double> until;            // [s] of the real bed: stop there instead of at time.end
  int threads = 0;                        // 0: as many as the machine has cores
  std::string command;                    // as typed, for the manifest
};

/// Where `run_case` writes.
std::filesystem::path results_folder(const CaseFile& case_file, const RunOptions& options);

/// Runs the case, talking to `out` (results) and to standard error (progress, warnings). Returns the exit status: 0 done,
/// 130/143 interrupted. A guard's SimulationError is written into the manifest and thrown on, as is whatever else ends the run
/// (OutputError of a full disk). Throws InputError, PluginError, OutputError before the run starts, leaving no half-written
/// folder; a signal while the bed settles leaves none either.
int run_case(const CaseFile& case_file, const Catalogue& catalogue, const RunOptions& options, std::ostream& out);

}  // namespace similitude
