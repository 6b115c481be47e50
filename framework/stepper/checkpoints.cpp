#include "stepper/checkpoints.h"

#include <csignal>

#include "output/monitors.h"
#include "output/probes.h"
#include "output/scalar_file.h"
#include "output/whole_file.h"

namespace similitude {
namespace {

constexpr int k_share_of_copies = 200;     // a copy may take one part in so many of the time
constexpr std::size_t k_kept = 2;          // if the newest turns out to be damaged there is one more

/// A thread that writes must not be the one that a signal to stop interrupts.
class SignalsHeld {
 public:
  SignalsHeld() {
    sigset_t all;
    sigfillset(&all);
    pthread_sigmask(SIG_SETMASK, &all, &before_);
  }
  ~SignalsHeld() { pthread_sigmask(SIG_SETMASK, &before_, nullptr); }
  SignalsHeld(const SignalsHeld&) = delete;
  SignalsHeld& operator=(const SignalsHeld&) = delete;

 private:
  sigset_t before_{};
};

}  // namespace

bool Snapshots::due() const { return !last_ || Clock::now() - taken_ >= k_share_of_copies * cost_; }

std::shared_ptr<RunState> Snapshots::unused() {
  // The copies take turns, so that the memory of each is touched once.
  std::shared_ptr<RunState> next = std::move(other_);
  if (!next || next.use_count() > 1) next = std::make_shared<RunState>();
  return next;
}

Checkpoints::Checkpoints(const OutputDirectory& directory, double every, RunIdentity run, std::deque<std::filesystem::path> kept,
                         std::function<void(const std::string&)> warn)
    : directory_(directory), every_(every), run_(std::move(run)), kept_(std::move(kept)), warn_(std::move(warn)) {}

Checkpoints::~Checkpoints() {
  if (writer_.joinable()) writer_.join();
}

bool Checkpoints::due() {
  if (!wanted() || writing_) return false;
  if (std::chrono::duration<double>(Clock::now() - last_).count() < every_) return false;
  wait();
  return true;
}

/// [writer, or main]
void Checkpoints::write_file(const RunState& state) {
  try {
    // No table may be shorter than the checkpoint says, whatever a power cut takes.
    for (const auto& [table, length] : {std::pair{k_monitors_file, state.outputs.monitors_length},
                                        std::pair{k_probes_file, state.outputs.probes_length},
                                        std::pair{k_scalars_file, state.outputs.scalars_length}}) {
      if (length > 0) sync_file(directory_.file(table));
    }
    const std::filesystem::path file = directory_.subfolder(k_checkpoint_folder) / checkpoint_name(state.simulation.steps_done);
    write_checkpoint(file, run_, state);
    if (kept_.empty() || kept_.front() != file) kept_.push_front(file);
    for (; kept_.size() > k_kept; kept_.pop_back()) {
      std::error_code ignored;
      std::filesystem::remove(kept_.back(), ignored);
    }
    failure_.clear();
  } catch (const std::exception& error) {   // a full disk, or memory that is gone
    failure_ = error.what();
  }
}

void Checkpoints::tell() {
  if (failure_.empty() || told_) return;
  told_ = true;
  warn_("no checkpoint was written; the run goes on" +
        (kept_.empty() ? std::string(" without one") : ", and the last good one is " + kept_.front().string()) + ". " + failure_);
}

void Checkpoints::wait() {
  if (!writer_.joinable()) return;
  writer_.join();
  tell();
}

void Checkpoints::write_behind(std::shared_ptr<const RunState> state) {
  wait();
  last_ = Clock::now();
  writing_ = true;
  const SignalsHeld inherited;
  writer_ = std::thread([this, state = std::move(state)]() mutable {
    write_file(*state);
    state.reset();
    writing_ = false;
  });
}

bool Checkpoints::write(const RunState& state) {
  wait();
  last_ = Clock::now();
  write_file(state);
  tell();
  return failure_.empty();
}

std::filesystem::path Checkpoints::newest() {
  wait();
  return kept_.empty() ? std::filesystem::path() : kept_.front();
}

}  // namespace similitude
