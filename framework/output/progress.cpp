#include "output/progress.h"

#include <unistd.h>

#include <algorithm>
#include <chrono>
#include <cmath>

#include "output/number.h"

namespace similitude {
namespace {

constexpr double k_redraw = 0.2;      // [s] of wall time, on a terminal
constexpr double k_first_lines = 5;   // [s] of wall time between plain lines, at first …
constexpr double k_later_lines = 60;  // [s] … and in a long run, whose log should stay readable
constexpr double k_line_every = 0.1;  // of the simulated time
constexpr std::size_t k_bar_columns = 20;

std::string duration(double seconds) {
  const auto whole = static_cast<long long>(std::llround(seconds));
  if (whole < 60) return std::to_string(whole) + " s";
  if (whole < 3600) return std::to_string(whole / 60) + " min " + std::to_string(whole % 60) + " s";
  return std::to_string(whole / 3600) + " h " + std::to_string(whole % 3600 / 60) + " min";
}

std::string rate(double per_second) {
  if (per_second >= 1e6) return readable(per_second / 1e6, 3) + " M ";
  if (per_second >= 1e3) return readable(per_second / 1e3, 3) + " k ";
  return readable(per_second, 3) + " ";
}

}  // namespace

double Progress::monotonic_seconds() {
  return std::chrono::duration<double>(std::chrono::steady_clock::now().time_since_epoch()).count();
}

Progress::Screen Progress::screen_of_standard_error() {
  return ::isatty(STDERR_FILENO) == 1 ? Screen::terminal : Screen::plain;
}

Progress::Progress(std::ostream& out, Screen screen, double end, Clock clock)
    : out_(out), screen_(screen), end_(end), clock_(std::move(clock)), began_(clock_()), last_drawn_(began_) {}

std::string Progress::line(const ProgressState& state, double now) const {
  const double fraction = end_ > 0 ? std::clamp(state.time / end_, 0.0, 1.0) : 1;
  const double elapsed = now - began_, advanced = state.time - first_time_;
  std::string text;
  if (screen_ == Screen::terminal) {
    const auto filled = static_cast<std::size_t>(fraction * k_bar_columns);
    text.append(1, '[').append(filled, '#').append(k_bar_columns - filled, '-').append("] ");
  }
  text +=
      readable(state.time) + " of " + readable(end_) + " s  " + std::to_string(static_cast<int>(fraction * 100)) + " %";
  if (fraction < 1)
    text += "  ETA " + (elapsed > 0 && advanced > 0 ? duration(elapsed * (end_ - state.time) / advanced) : "?");
  if (elapsed > 0) text += "  " + rate(static_cast<double>(state.particle_steps) / elapsed) + "particle-steps/s";
  return text + "  " + std::to_string(state.particles) + " particles  overlap " +
         readable(100 * state.largest_overlap, 2) + " % of d";
}

void Progress::draw(const ProgressState& state, double now) {
  std::string text = line(state, now);
  if (screen_ == Screen::terminal) {
    const std::size_t length = text.size();
    if (length < last_length_) text.append(last_length_ - length, ' ');  // wipes the rest of a longer line
    last_length_ = length;
    out_ << '\r' << text << std::flush;
  } else {
    out_ << text << '\n' << std::flush;
  }
  last_drawn_ = now;
  last_fraction_ = end_ > 0 ? state.time / end_ : 1;
}

void Progress::update(const ProgressState& state) {
  const double now = clock_();
  if (first_time_ < 0) {
    first_time_ = state.time;
    last_fraction_ = end_ > 0 ? state.time / end_ : 1;
  }
  const double waited = now - last_drawn_;
  if (screen_ == Screen::terminal) {
    if (waited >= k_redraw) draw(state, now);
    return;
  }
  const double patience = std::clamp((now - began_) / 10, k_first_lines, k_later_lines);
  const bool far = end_ > 0 && state.time / end_ - last_fraction_ >= k_line_every;
  if (far || waited >= patience) draw(state, now);
}

void Progress::finish(const ProgressState& state) {
  if (first_time_ < 0) first_time_ = state.time;
  draw(state, clock_());
  if (screen_ == Screen::terminal) out_ << '\n' << std::flush;
}

}  // namespace similitude
