#pragma once
/// Where a run can go on, and whether this case may.

#include <deque>
#include <filesystem>
#include <functional>
#include <string>

#include "output/checkpoint_file.h"
#include "output/directory.h"
#include "scene/case_file.h"

namespace similitude {

/// A run as its newest readable checkpoint left it.
struct EarlierRun {
  Checkpoint checkpoint;
  std::deque<std::filesystem::path> files;   // checkpoints up to that one, the newest first
};

/// Reads the bed's file, if it has one, for its hash.
CaseIdentity identity_of(const CaseFile& case_file);

/// In what two cases differ, so that a run of one is none of the other: a line for every value by its path, each indented and on
/// a line of its own; "" if in nothing. When to end, how often to write, the title, and where plugins and the bed's file lie
/// do not count: a bed's file is compared by its bytes, where the earlier run tells them.
std::string case_differences(const CaseIdentity& before, const CaseIdentity& now);

/// Reads the newest checkpoint of the folder. One that is cut short or altered is told, set aside under a name ending in
/// .damaged, and the one before is read. InputError, saying what to do, if none can be read, or the newest has another format or cannot
/// be opened.
EarlierRun newest_checkpoint(const OutputDirectory& directory, const std::function<void(const std::string&)>& warn);

/// Throws InputError naming every difference between the cases (case_differences) and between the time steps, PluginError for every plugin whose id, version or file is another.
void refuse_another_run(const RunIdentity& before, const RunIdentity& now);

}  // namespace similitude
