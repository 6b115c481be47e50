#pragma once
/// How fast an error falls with a step or a cell.

#include <string>
#include <vector>

#include "study/estimate.h"

namespace similitude {

struct OrderPoint {
  double step = 0;  // [s] or [m]
  Estimate error;
};

/// The p of error ~ step^p by least squares in the logarithms, of the points whose interval lies above zero.
/// `reference_step`: the step of the case that errors are taken against, whose own error is missing from them: error ~
/// step^p - reference_step^p; 0 if the reference is exact. The interval comes from the coarsest and the finest point's.
/// A gap with fewer than two such points.
Estimate observed_order(const std::vector<OrderPoint>& points, double reference_step);

}  // namespace similitude
