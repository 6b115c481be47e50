#pragma once

namespace similitude::app {

/// Starts the program again with OMP_WAIT_POLICY=passive unless the user has chosen a policy. Returns only if that is the
/// case already or cannot be had.
///
/// Threads that spin at barriers gain nothing here (a sub-step takes milliseconds) and lose much when the machine has
/// other work: a two-thread run beside one compiler was four times slower. The OpenMP library reads the policy when it
/// is loaded, before main(), so setting it from inside needs a second start.
void let_waiting_threads_sleep(char** arguments);

}  // namespace similitude::app
