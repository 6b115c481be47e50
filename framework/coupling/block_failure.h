#pragma once
/// What goes wrong in a pass over blocks, told once: the words of the first block that failed, whichever thread met it.

#include <cstddef>
#include <limits>

#include <similitude/abi.h>

#include "loader/catalogue.h"

namespace similitude {

class BlockFailure {
 public:
  /// Of one block; a status without a failure is passed over. [worker]
  void tell(std::size_t block, const similitude_status& status);

  explicit operator bool() const { return block_ != k_none; }
  std::size_t block() const { return block_; }
  const similitude_status& status() const { return status_; }

 private:
  static constexpr std::size_t k_none = std::numeric_limits<std::size_t>::max();
  std::size_t block_ = k_none;
  similitude_status status_{};
};

/// Throws SimulationError in the effect's own words.
[[noreturn]] void throw_failure(const EffectModel& effect, const similitude_status& status);

}  // namespace similitude
