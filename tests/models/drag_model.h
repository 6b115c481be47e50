#pragma once
/// A drag law's library as the drag tests see it: K of one particle, a state at a time, in the gas of the reference tables.

#include <gtest/gtest.h>
#include <similitude/drag_correlations.h>

#include "columns.h"
#include "plugin_file.h"

namespace similitude::test {

using DragModel = TestModel<similitude_drag_functions>;

constexpr double k_diameter = 1e-3, k_density = 1.225, k_viscosity = 1.79e-5;
constexpr double k_cell_size = 5e-3;   // [m]
inline const double k_volume = sphere_volume(k_diameter);
inline const double k_stokes = 3 * k_pi * k_viscosity * k_diameter;

/// The states of the table of beta/phi.
struct State {
  double gas_fraction, slip;
};
constexpr State k_states[] = {{0.4, 1}, {0.45, 0.8}, {0.6, 1}, {0.8, 2}, {0.8001, 2}, {0.85, 2}, {0.9, 3}, {0.99, 4}, {1, 3.5}};

/// A particle in its gas; by default of the reference tables.
struct Particle {
  double gas_fraction, slip;
  double diameter = k_diameter, density = k_density, viscosity = k_viscosity, cell_size = k_cell_size;
};

/// K [kg/s] of one particle, by any functions and instance; the same state in all rows must give the same bits.
inline double exchange(const similitude_drag_functions& functions, const void* instance, const Particle& particle) {
  Column d(8, particle.diameter), eps(8, particle.gas_fraction), u(8, particle.slip), rho(8, particle.density),
      mu(8, particle.viscosity), sauter(8, particle.diameter), cell(8, particle.cell_size), k(8);
  similitude_drag_needs needs{};
  needs.struct_size = sizeof needs;
  functions.needs(instance, &needs);
  const similitude_drag_block block = {sizeof block,
                                       8,
                                       d.data(),
                                       eps.data(),
                                       u.data(),
                                       rho.data(),
                                       mu.data(),
                                       needs.sauter_diameter ? sauter.data() : nullptr,
                                       needs.cell_size ? cell.data() : nullptr,
                                       k.data()};
  similitude_status status{};
  functions.exchange(instance, &block, &status);
  EXPECT_EQ(status.code, 0) << status.text;
  for (std::size_t row = 1; row < 8; ++row) EXPECT_EQ(k[row], k[0]);
  return k[0];
}

inline double exchange(const DragModel& law, const Particle& particle) {
  return exchange(law.functions(), law.instance(), particle);
}
inline double exchange(const DragModel& law, double gas_fraction, double slip) {
  return exchange(law, Particle{gas_fraction, slip});
}

/// The interstitial slip [m/s] of a Reynolds number.
inline double slip_for(double reynolds) { return reynolds * k_viscosity / (k_density * k_diameter); }

/// K over Stokes' at a gas fraction and an interstitial Reynolds number.
inline double factor(const DragModel& law, double gas_fraction, double reynolds) {
  return exchange(law, gas_fraction, slip_for(reynolds)) / k_stokes;
}

/// The interstitial slip at which a bed of this gas fraction is carried: (beta/phi) u = eps (rho_p - rho_f) g.
inline double carrying_slip(const DragModel& law, double gas_fraction, const similitude_bed& bed) {
  const double weight =
      gas_fraction * (bed.particle_density - bed.gas_density) * bed.gravity * sphere_volume(bed.drag_diameter);
  double low = 0, high = 100;
  for (int halving = 0; halving < 60; ++halving) {
    const double middle = 0.5 * (low + high);
    const double k = exchange(law, {gas_fraction, middle, bed.drag_diameter, bed.gas_density, bed.gas_viscosity});
    (k * middle > weight ? high : low) = middle;
  }
  return high;
}

}  // namespace similitude::test
