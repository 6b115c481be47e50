#pragma once
#include <similitude/effect.h>

#include <numbers>

/// Rough spheres: a share of Stokes' drag on top of what the drag law gives. Put your effect here, and its source into this
/// comment.
struct @Type@ {
  double share;  // [-]

  static void parameters(similitude::Parameters<@Type@>& p) {
    p.real("share", &@Type@::share, {.unit = "1", .def = 0.1, .min = 0, .max = 10, .doc = "of Stokes' drag, added"});
  }

  /// Without it the effect cannot tell whether a bed calls for it.
  similitude::Relevance relevance(const similitude::Evidence&) const {
    return {.verdict = share > 0.01 ? similitude::Verdict::needed : similitude::Verdict::negligible,
            .value = share,
            .threshold = 0.01,
            .group = "added over Stokes' drag",
            .source = "drag laws are not known to a percent"};
  }

  /// On one particle; the gas receives the opposite.
  template <class V>
  similitude::Addition<V> particles(const similitude::Particle<V>& p) const {
    similitude::Addition<V> added;
    added.linear_coefficient = share * 3 * std::numbers::pi * (p.gas_viscosity * p.diameter);
    return added;
  }
};
