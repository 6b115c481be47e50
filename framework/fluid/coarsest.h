#pragma once
/// Direct solution on the coarsest level. Regions without a pressure patch have no pressure level of their own: the
/// constant is taken out there, and the answer has zero mean.

#include <memory>

#include "fluid/levels.h"

namespace similitude::multigrid {

class Coarsest {
 public:
  explicit Coarsest(const Level& level);
  ~Coarsest();
  Coarsest(Coarsest&&) noexcept;

  void factor(const Level& level);
  /// level.x = inverse of A applied to level.b.
  void solve(Level& level);

 private:
  struct Parts;
  std::unique_ptr<Parts> parts_;
};

}  // namespace similitude::multigrid
