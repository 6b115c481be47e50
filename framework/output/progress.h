#pragma once
/// How far a run is. A bar that redraws itself on a terminal; elsewhere a plain line now and then.

#include <cstdint>
#include <functional>
#include <ostream>
#include <string>

namespace similitude {

/// Of the real bed.
struct ProgressState {
  double time = 0;                   // [s]
  std::uint64_t particle_steps = 0;  // since the run began
  std::uint64_t particles = 0;
  double largest_overlap = 0;  // [-], over a diameter
};

class Progress {
 public:
  enum class Screen { terminal, plain };
  using Clock = std::function<double()>;  // [s], monotonic

  /// `end` [s]: the real bed's end time.
  Progress(std::ostream& out, Screen screen, double end, Clock clock = monotonic_seconds);

  /// Call as often as you like: draws at most five times a second on a terminal; elsewhere a line every 10 % and, in
  /// between, every 5 s of wall time (every minute in a run of hours). The first state is the start of the estimate.
  void update(const ProgressState& state);
  /// Leaves the last state standing.
  void finish(const ProgressState& state);

  static double monotonic_seconds();
  /// terminal if standard error is one.
  static Screen screen_of_standard_error();

 private:
  std::string line(const ProgressState& state, double now) const;
  void draw(const ProgressState& state, double now);

  std::ostream& out_;
  Screen screen_;
  double end_;
  Clock clock_;
  double began_, last_drawn_;
  double first_time_ = -1, last_fraction_ = 0;
  std::size_t last_length_ = 0;
};

}  // namespace similitude
