#pragma once

namespace similitude::app {

/// Starts the program again with a short spin count for waiting threads, unless the user has chosen how they wait. Returns
/// only if that is the case already or cannot be had.
///
/// A gas step has hundreds of short parallel loops. Threads that sleep at once at every barrier make a run on two free
/// cores 1.6 times slower; threads that spin long make a run beside other work up to four times slower. A few
/// thousand turns (some microseconds) cost neither. The OpenMP library reads the count when it is loaded, before
/// main(), so setting it from inside needs a second start.
void let_waiting_threads_sleep_soon(char** arguments);

}  // namespace similitude::app
