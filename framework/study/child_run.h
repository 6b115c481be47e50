#pragma once
/// A run in a process of its own: it cannot take the study down, its memory is its own, and its clock starts fresh.

#include <filesystem>
#include <string>
#include <vector>

namespace similitude {

struct ChildOutcome {
  int exit_status = 0;           // 128 + signal if one ended it
  double peak_memory_bytes = 0;  // largest resident set
};

/// `similitude arguments…`, of this very program; what it says goes to the end of `log`. A StopSignal is handed on, and
/// the child ends with this process. Throws OutputError if the log cannot be written or no process can be made.
ChildOutcome run_child(const std::vector<std::string>& arguments, const std::filesystem::path& log);

/// The last "error: …" of a log with its fix, without the word error; "" if there is none.
std::string last_error_in(const std::filesystem::path& log);

}  // namespace similitude
