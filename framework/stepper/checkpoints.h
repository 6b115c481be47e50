#pragma once
/// The checkpoints of a run: when one is due, written behind the run's back, the last two kept.

#include <atomic>
#include <chrono>
#include <cstdint>
#include <deque>
#include <filesystem>
#include <functional>
#include <memory>
#include <string>
#include <thread>

#include "output/checkpoint_file.h"
#include "output/directory.h"

namespace similitude {

/// Copies of the run's state in memory, for checkpoints and for going back after a step that failed in its middle. One is
/// taken as often as it costs next to nothing; none changes what is computed.
class Snapshots {
 public:
  /// Has the run gone on for so long that a copy is negligible?
  bool due() const;
  /// Calls fill(state) on memory that nobody reads any more. If it throws, the last copy stays.
  template <class Fill>
  void take(Fill&& fill) {
    const Clock::time_point start = Clock::now();
    std::shared_ptr<RunState> next = unused();
    fill(*next);
    other_ = std::move(last_);
    last_ = std::move(next);
    taken_ = Clock::now();
    cost_ = taken_ - start;
    seconds_ += std::chrono::duration<double>(cost_).count();
  }
  /// Null before the first.
  const std::shared_ptr<RunState>& last() const { return last_; }
  double seconds() const { return seconds_; }   // [s], of wall time that all copies took
  static constexpr std::size_t k_copies = 2;    // they take turns; a third only while a file is being written for long

 private:
  using Clock = std::chrono::steady_clock;
  std::shared_ptr<RunState> unused();   // taken out of `other_`, or new

  std::shared_ptr<RunState> last_, other_;
  Clock::time_point taken_{};
  Clock::duration cost_{};
  double seconds_ = 0;
};

class Checkpoints {
 public:
  /// `every` [s] of wall-clock time; 0: never. `kept`: the files of an earlier start, the newest first.
  Checkpoints(const OutputDirectory& directory, double every, RunIdentity run, std::deque<std::filesystem::path> kept,
              std::function<void(const std::string&)> warn);
  /// Waits for the file that is being written.
  ~Checkpoints();
  Checkpoints(const Checkpoints&) = delete;
  Checkpoints& operator=(const Checkpoints&) = delete;

  bool wanted() const { return every_ > 0; }
  /// Is the interval over, and nothing being written?
  bool due();
  /// In a thread of its own, one at a time. A failure is told once; the run goes on and the last good files stay. [main]
  void write_behind(std::shared_ptr<const RunState> state);
  /// At once; true: the file is there. [main]
  bool write(const RunState& state);
  /// Waits; empty: there is none.
  std::filesystem::path newest();

 private:
  using Clock = std::chrono::steady_clock;
  void write_file(const RunState& state);
  void wait();
  void tell();

  const OutputDirectory& directory_;
  double every_;
  RunIdentity run_;
  std::deque<std::filesystem::path> kept_;
  std::function<void(const std::string&)> warn_;
  Clock::time_point last_ = Clock::now();
  std::thread writer_;
  std::atomic<bool> writing_{false};
  std::string failure_;       // of the last file; "" if it is there
  bool told_ = false;
};

}  // namespace similitude
