#include "app/waiting_threads.h"

#include <cstdlib>

#include <unistd.h>

namespace similitude::app {

void let_waiting_threads_sleep(char** arguments) {
  constexpr const char* k_policy = "OMP_WAIT_POLICY";
  if (std::getenv(k_policy) != nullptr) return;
  if (::setenv(k_policy, "passive", 0) != 0) return;
  ::execv("/proc/self/exe", arguments);
}

}  // namespace similitude::app
