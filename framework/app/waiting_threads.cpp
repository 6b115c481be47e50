#include "app/waiting_threads.h"

#include <cstdlib>

#include <unistd.h>

namespace similitude::app {

void let_waiting_threads_sleep_soon(char** arguments) {
  constexpr const char* k_spin_count = "GOMP_SPINCOUNT";
  constexpr const char* k_turns = "3000";
  if (std::getenv("OMP_WAIT_POLICY") != nullptr || std::getenv(k_spin_count) != nullptr) return;
  if (::setenv(k_spin_count, k_turns, 0) != 0) return;
  ::execv("/proc/self/exe", arguments);
}

}  // namespace similitude::app
