#pragma once
/// Where the main thread's time goes: every lap adds the time since the last one to a stage.

#include <array>
#include <chrono>
#include <cstddef>

namespace similitude {

enum class Stage : std::size_t { list, contacts, walls, exchange, integrate, waiting };
constexpr std::size_t k_stage_count = 6;
constexpr std::array<const char*, k_stage_count> k_stage_names{"neighbour list", "contacts",  "walls",
                                                               "exchange",       "integrate", "waiting for threads"};

class StageClock {
 public:
  void start() { last_ = Clock::now(); }
  void lap(Stage stage) {
    const Clock::time_point now = Clock::now();
    spent_[static_cast<std::size_t>(stage)] += now - last_;
    last_ = now;
  }
  double seconds(std::size_t stage) const { return std::chrono::duration<double>(spent_[stage]).count(); }

 private:
  using Clock = std::chrono::steady_clock;
  Clock::time_point last_;
  std::array<Clock::duration, k_stage_count> spent_{};
};

}  // namespace similitude
