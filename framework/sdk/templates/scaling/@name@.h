#pragma once
#include <similitude/scaling_law.h>

/// Grains that stand for n^3 particles each: drag sees the particles, contacts see the grains, whose springs are n times as
/// stiff. Put your ratios here, and their source into this comment.
struct @Type@ {
  double n;  // [-], a grain's diameter over that of its particles

  static void parameters(similitude::Parameters<@Type@>& p) {
    p.real("n", &@Type@::n, {.unit = "1", .def = 2, .min = 1, .max = 100, .doc = "diameter of a grain over a particle's"});
  }

  /// Simulated over real; what is not set stays 1.
  similitude::Ratios ratios(const similitude::Bed&) const {
    similitude::Ratios r;
    r.diameter = n;
    r.parcel_weight = n * n * n;
    r.stiffness = n;
    return r;
  }
};
