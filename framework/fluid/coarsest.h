#pragma once
/// Direct solution on the coarsest level. Regions without a pressure patch have no pressure level of their own: the
/// constant is taken out there, and the answer has zero mean.

#include <memory>
#include <vector>

#include "fluid/levels.h"

namespace similitude::multigrid {

class Coarsest {
 public:
  explicit Coarsest(const Level& level);
  ~Coarsest();

  void factor(const Level& level);
  /// level.x = inverse of A applied to level.b.
  void solve(Level& level);

 private:
  struct Factors;   // Eigen's
  /// Adds the constant to every region that no pressure patch reaches, so that the matrix can be inverted.
  void pin_closed_regions(const Level& level);

  Index count_;
  std::unique_ptr<Factors> factors_;
  std::vector<Index> region_, stack_;
};

}  // namespace similitude::multigrid
