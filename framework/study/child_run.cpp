#include "study/child_run.h"

#include <fcntl.h>
#include <sys/prctl.h>
#include <sys/resource.h>
#include <sys/wait.h>
#include <unistd.h>

#include <cerrno>
#include <chrono>
#include <csignal>
#include <fstream>
#include <thread>

#include "output/whole_file.h"
#include "stepper/stop_signal.h"

namespace similitude {
namespace {

constexpr std::chrono::milliseconds k_look_again{10};
constexpr int k_exit_of_signal = 128;  // shells' convention
constexpr int k_cannot_run = 127;      // shells' convention

/// Between fork and exec: only calls that are safe there.
[[noreturn]] void become(char* const* arguments, int log, ::pid_t parent) {
  // Of a process group of its own, so that Ctrl-C reaches it once, through the study.
  ::setpgid(0, 0);
  ::prctl(PR_SET_PDEATHSIG, SIGTERM);
  if (::getppid() != parent) ::_exit(k_cannot_run);
  std::signal(SIGINT, SIG_DFL);
  std::signal(SIGTERM, SIG_DFL);
  ::dup2(log, STDOUT_FILENO);
  ::dup2(log, STDERR_FILENO);
  ::execv("/proc/self/exe", arguments);
  ::_exit(k_cannot_run);
}

}  // namespace

ChildOutcome run_child(const std::vector<std::string>& arguments, const std::filesystem::path& log) {
  const int descriptor = ::open(log.c_str(), O_WRONLY | O_CREAT | O_APPEND | O_CLOEXEC, 0666);
  if (descriptor < 0) throw_output_error(log, "written", errno);
  std::vector<std::string> words{"similitude"};
  words.insert(words.end(), arguments.begin(), arguments.end());
  std::vector<char*> pointers;
  for (std::string& word : words) pointers.push_back(word.data());
  pointers.push_back(nullptr);

  const ::pid_t parent = ::getpid();
  const ::pid_t child = ::fork();
  if (child == 0) become(pointers.data(), descriptor, parent);
  const int error = errno;
  ::close(descriptor);
  if (child < 0) throw_output_error(log, "filled by a process of its own", error);

  int status = 0;
  ::rusage used{};
  bool told = false;
  while (::wait4(child, &status, WNOHANG, &used) == 0) {
    if (const int signal_number = StopSignal::received(); signal_number != 0 && !told) {
      ::kill(child, signal_number);
      told = true;
    }
    std::this_thread::sleep_for(k_look_again);
  }
  constexpr double k_bytes_per_unit = 1024;  // ru_maxrss is in KiB
  return {.exit_status = WIFSIGNALED(status) ? k_exit_of_signal + WTERMSIG(status) : WEXITSTATUS(status),
          .peak_memory_bytes = k_bytes_per_unit * static_cast<double>(used.ru_maxrss)};
}

std::string last_error_in(const std::filesystem::path& log) {
  constexpr std::string_view k_error = "error: ";
  std::ifstream stream(log);
  std::string text;
  bool inside = false;
  for (std::string line; std::getline(stream, line);) {
    if (const std::size_t at = line.find(k_error);
        at != std::string::npos && (at == 0 || line[at - 1] == '\r' || line[at - 1] == '\n')) {
      text = line.substr(at + k_error.size());
      inside = true;
    } else if (inside && line.starts_with("  ")) {
      text += "\n" + line;
    } else {
      inside = false;
    }
  }
  return text;
}

}  // namespace similitude
