#pragma once
/// Regions of cells that no pressure patch reaches: their pressure is known up to a constant.

#include <vector>

#include "fluid/levels.h"

namespace similitude::multigrid {

class ClosedRegions {
 public:
  explicit ClosedRegions(const Staggered& mesh);

  std::size_t count() const { return regions_.size(); }
  /// Makes the mean of a field of the finest level zero over every closed region. The largest |mean| there was.
  double subtract_mean(std::vector<double>& field) const;

 private:
  std::vector<std::vector<Index>> regions_;  // rows of the finest level
};

/// Cells connected through open faces carry the same label.
struct Regions {
  explicit Regions(const Staggered& mesh);
  std::vector<std::size_t> label;     // by cell
  std::vector<bool> reaches_outlet;   // by label: touches a pressure patch
};

}  // namespace similitude::multigrid
