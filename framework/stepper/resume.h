#pragma once
/// Where a run can go on, and whether this case may.

#include <deque>
#include <filesystem>
#include <functional>
#include <string>

#include "output/checkpoint_file.h"
#include "output/directory.h"

namespace similitude {

/// A run as its newest readable checkpoint left it.
struct EarlierRun {
  Checkpoint checkpoint;
  std::deque<std::filesystem::path> files;   // checkpoints up to that one, the newest first
};

/// Reads the newest checkpoint of the folder. One that is cut short or altered is told, set aside under a name ending in
/// .damaged, and the one before is read. InputError, saying what to do, if none can be read or the newest has another format.
EarlierRun newest_checkpoint(const OutputDirectory& directory, const std::function<void(const std::string&)>& warn);

/// Throws InputError naming every difference between the cases (beyond when to end, how often to write, and the title) and
/// between the time steps, PluginError for every plugin whose id, version or file is another.
void refuse_another_run(const RunIdentity& before, const RunIdentity& now);

}  // namespace similitude
