#pragma once
/// A checkpoint on the disk: the state of a run and what it belongs to. HDF5, described for users in
/// docs/reference/output-files.md.

#include <cstdint>
#include <filesystem>
#include <string>
#include <vector>

#include "output/hdf5_file.h"
#include "output/manifest.h"
#include "output/run_state.h"

namespace similitude {

/// Raised when an older program would misread a file, or this one an older file.
inline constexpr std::uint64_t k_checkpoint_format = 2;

/// What a state belongs to: it goes on with the same case, steps and plugins only.
struct RunIdentity : CaseIdentity {
  std::string program_version;
  std::vector<ManifestPlugin> plugins;
  double dt = 0;                         // [s], sub-step, simulated bed
  std::int64_t sub_steps = 0;            // to a gas step
  std::uint64_t particles = 0;           // simulated, at the start
  double solids_fraction = 0, height = 0;   // [-], [m] simulated; of the bed at the start
  std::string started;                   // UTC
  std::vector<Resumption> resumed;
};

struct Checkpoint {
  RunIdentity run;
  RunState state;
};

/// The file is whole, but of another format.
class CheckpointFormatError : public std::runtime_error {
 public:
  using std::runtime_error::runtime_error;
};

/// Under a temporary name, synced, renamed. Throws OutputError.
void write_checkpoint(const std::filesystem::path& file, const RunIdentity& run, const RunState& state);
/// Throws Hdf5Error for a file that is cut short or altered, CheckpointFormatError for one of another format.
Checkpoint read_checkpoint(const std::filesystem::path& file);

/// checkpoint_000001200.h5, by gas steps done.
std::string checkpoint_name(std::int64_t steps_done);
/// All of a folder, the newest first; none if there is no such folder.
std::vector<std::filesystem::path> checkpoints_in(const std::filesystem::path& folder);

}  // namespace similitude
