#include "doctor/child.h"

#include <fmt/format.h>
#include <poll.h>
#include <sys/mman.h>
#include <sys/wait.h>
#include <ucontext.h>
#include <unistd.h>

#include <cerrno>
#include <chrono>
#include <csignal>
#include <cstdio>
#include <cstring>
#include <new>
#include <stdexcept>

#include "doctor/guarded_column.h"

namespace similitude::doctor {
namespace {

/// The last words of a child that crashes, in memory that its parent sees.
struct LastWords {
  int signal = 0;
  bool writing = false;
  ForbiddenTouch touch;
};
LastWords* last_words = nullptr;

constexpr int k_crashed = 101;     // exit status of a child that left last words
constexpr int k_answered = 102;    // of one that wrote its whole answer
constexpr std::size_t k_signal_stack = 1 << 16;   // [bytes]

bool was_a_write([[maybe_unused]] void* context) {
#if defined(__x86_64__)
  constexpr greg_t write_bit = 2;   // of the page fault's error code
  return (static_cast<ucontext_t*>(context)->uc_mcontext.gregs[REG_ERR] & write_bit) != 0;
#else
  return false;
#endif
}

void say_last_words(int signal, siginfo_t* info, void* context) {
  last_words->signal = signal;
  if (signal == SIGSEGV || signal == SIGBUS) {
    last_words->writing = was_a_write(context);
    last_words->touch = touch_at(info->si_addr);
  }
  _exit(k_crashed);
}

void listen_for_crashes() {
  static char stack[k_signal_stack];
  stack_t other{};
  other.ss_sp = stack;
  other.ss_size = sizeof stack;
  sigaltstack(&other, nullptr);
  struct sigaction action{};
  action.sa_sigaction = say_last_words;
  action.sa_flags = SA_SIGINFO | SA_ONSTACK;
  for (const int signal : {SIGSEGV, SIGBUS, SIGFPE, SIGILL, SIGABRT}) sigaction(signal, &action, nullptr);
}

[[noreturn]] void be_the_child(int pipe_end, const std::function<std::string()>& work) {
  std::fflush(nullptr);
  dup2(STDERR_FILENO, STDOUT_FILENO);
  listen_for_crashes();
  const std::string text = work();
  std::size_t written = 0;
  while (written < text.size()) {
    const ssize_t n = write(pipe_end, text.data() + written, text.size() - written);
    if (n <= 0) _exit(1);
    written += static_cast<std::size_t>(n);
  }
  _exit(k_answered);   // without the end of statics: a sick library's own may crash, and nobody asks
}

/// Reads until the child closes its end. False if the time ran out.
bool read_all(int pipe_end, double limit, std::string& text) {
  using Clock = std::chrono::steady_clock;
  const auto deadline = Clock::now() + std::chrono::duration<double>(limit);
  while (true) {
    const auto left = std::chrono::duration_cast<std::chrono::milliseconds>(deadline - Clock::now()).count();
    if (left <= 0) return false;
    pollfd wait{pipe_end, POLLIN, 0};
    const int ready = poll(&wait, 1, static_cast<int>(left));
    if (ready < 0 && errno == EINTR) continue;
    if (ready <= 0) return false;
    char buffer[4096];
    const ssize_t n = read(pipe_end, buffer, sizeof buffer);
    if (n <= 0) return true;
    text.append(buffer, static_cast<std::size_t>(n));
  }
}

ChildAnswer death_by_touch(const LastWords& words) {
  const ForbiddenTouch& touch = words.touch;
  const bool beyond = touch.row >= static_cast<long>(touch.rows), before = touch.row < 0;
  if (!beyond && !before)
    return {false, fmt::format("it writes into the column {}, which it is given to read.", touch.column),
            "Write only to the columns that abi.h calls out."};
  return {false,
          fmt::format("it {} {} the column {} of {} rows, at row {}.", words.writing ? "writes" : "reads",
                      beyond ? "beyond the end of" : "before the start of", touch.column, touch.rows, touch.row),
          "Rows run from 0 to block->rows - 1, which is a multiple of 8. The loops of the SDK's headers keep to that."};
}

ChildAnswer death_by_signal(const LastWords& words) {
  if (words.touch.column[0] != 0) return death_by_touch(words);
  switch (words.signal) {
    case SIGSEGV:
    case SIGBUS:
      return {false, "it crashes: it touches memory that is not its own.",
              "Run the check under a debugger: gdb --args similitude plugins doctor FILE, with set follow-fork-mode child."};
    case SIGFPE:
      return {false, "it crashes: a whole number is divided by zero.", "Look for an integer division."};
    case SIGILL:
      return {false, "it crashes: the processor does not know an instruction.",
              "Rebuild it for this processor, and look for __builtin_unreachable() and missing returns."};
    default:
      return {false, "it gives up: abort() was called.",
              "Look for a failed assertion, or an exception that leaves a function declared noexcept."};
  }
}

}  // namespace

ChildAnswer in_child(const std::function<std::string()>& work, double limit) {
  void* shared = mmap(nullptr, sizeof(LastWords), PROT_READ | PROT_WRITE, MAP_SHARED | MAP_ANONYMOUS, -1, 0);
  int ends[2];
  if (shared == MAP_FAILED || pipe(ends) != 0) throw std::runtime_error("a child process cannot be prepared.");
  last_words = new (shared) LastWords;
  std::fflush(nullptr);
  const pid_t child = fork();
  if (child < 0) throw std::runtime_error(std::string("a child process cannot be started: ") + std::strerror(errno) + ".");
  if (child == 0) {
    close(ends[0]);
    be_the_child(ends[1], work);
  }
  close(ends[1]);
  ChildAnswer answer;
  const bool in_time = read_all(ends[0], limit, answer.text);
  close(ends[0]);
  if (!in_time) kill(child, SIGKILL);
  int status = 0;
  while (waitpid(child, &status, 0) < 0 && errno == EINTR) {
  }
  const LastWords words = *last_words;
  munmap(shared, sizeof(LastWords));
  last_words = nullptr;
  if (!in_time)
    return {false, fmt::format("it does not come to an end: stopped after {:g} s.", limit),
            "Look for a loop whose end depends on what it computes."};
  if (WIFEXITED(status) && WEXITSTATUS(status) == k_answered) {
    answer.lived = true;
    return answer;
  }
  if (WIFEXITED(status) && WEXITSTATUS(status) == k_crashed) return death_by_signal(words);
  if (WIFEXITED(status))
    return {false, fmt::format("it ends the whole program: exit({}).", WEXITSTATUS(status)),
            "Say what is wrong in the status instead; C++ authors throw."};
  return {false, fmt::format("it dies of signal {}.", WTERMSIG(status)), "Run the check under a debugger."};
}

}  // namespace similitude::doctor
