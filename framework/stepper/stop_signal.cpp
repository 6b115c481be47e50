#include "stepper/stop_signal.h"

#include <csignal>
#include <ctime>

namespace similitude {
namespace {

volatile std::sig_atomic_t g_received = 0;
volatile std::time_t g_first_at = 0;  // [s]

// [s], in whole seconds of the clock. timeout(1) and batch systems send a signal to the program and once more to its group.
constexpr std::time_t k_one_request = 2;

/// Whoever presses Ctrl-C again after a while means it: that ends the program at once.
void remember(int signal_number) {
  timespec now{};
  clock_gettime(CLOCK_MONOTONIC, &now);
  if (g_received == 0) {
    g_received = signal_number;
    g_first_at = now.tv_sec;
  } else if (now.tv_sec - g_first_at >= k_one_request) {
    std::signal(signal_number, SIG_DFL);
    std::raise(signal_number);
  }
}

}  // namespace

StopSignal::StopSignal() {
  g_received = 0;
  std::signal(SIGINT, remember);
  std::signal(SIGTERM, remember);
}

StopSignal::~StopSignal() {
  std::signal(SIGINT, SIG_DFL);
  std::signal(SIGTERM, SIG_DFL);
}

int StopSignal::received() { return g_received; }

}  // namespace similitude
