#include "stepper/stop_signal.h"

#include <csignal>

namespace similitude {
namespace {

volatile std::sig_atomic_t g_received = 0;

/// The second signal of a kind ends the program at once: whoever presses Ctrl-C twice means it.
void remember(int signal_number) {
  g_received = signal_number;
  std::signal(signal_number, SIG_DFL);
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
