#pragma once
/// The speed, here, of a run that was made elsewhere: it goes on for a moment in a folder of its own.

#include <filesystem>
#include <optional>
#include <string>

#include "study/run_files.h"

namespace similitude {

struct Leg {
  double simulated_s = 0;  // [s] of the real bed
  double peak_memory_bytes = 0;
  RunTiming whole_run;  // as long a run as the finished one at the leg's speed
};

/// Goes on from the newest checkpoint of the finished run in `run`, where the bed is as it mostly was, for `length` [s] of
/// the real bed; from the start if it kept none that can be read. `threads` 0: all cores. Returns a line that says how it
/// went. Throws OutputError.
std::string run_leg(const std::filesystem::path& run, const std::filesystem::path& leg, double length, int threads);

/// The case of a leg that was run, in full.
std::filesystem::path case_of_leg(const std::filesystem::path& leg);

/// Of a leg that was run for this very case; empty if there is none.
std::optional<Leg> read_leg(const std::filesystem::path& run, const std::filesystem::path& leg);

}  // namespace similitude
