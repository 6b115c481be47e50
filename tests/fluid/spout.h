#pragma once
/// A spouted bed as a gas solver meets it, with prescribed particles, in units of any size.

#include <array>
#include <cmath>

#include "gas_run.h"

namespace similitude::test {

/// Ratios of a scaled bed, all powers of two.
struct Units {
  double length = 1, time = 1, viscosity = 1, exchange = 1;
  double velocity() const { return length / time; }
};

/// A spout between plates in a bed that breathes.
struct Spout {
  explicit Spout(std::array<int, 3> cells = {13, 3, 37}, Units ratios = {}, double spacing = 0.005)
      : units(ratios),
        box({.cells = cells, .spacing = {spacing * units.length, spacing * units.length, spacing * units.length}}) {
    const auto [nx, ny, nz] = cells;
    const std::uint8_t background = box.velocity_patch("background", {0, 0, 0.46 * units.velocity()}, 0.004 * units.time);
    const std::uint8_t spout = box.velocity_patch("spout", {0, 0, 6.5 * units.velocity()}, 0.004 * units.time);
    box.set_side(2, 0, background);
    box.set_faces(2, 0, {nx / 2 - 1, 0, 0}, {nx / 2 + 1, ny, 0}, spout);
    box.set_side(2, 1, box.pressure_patch("outlet", 0));
    for (const int plate : {2 * nx / 5, 3 * nx / 5}) box.set_faces(0, plate, {0, 0, 3}, {0, ny, nz / 4}, SIMILITUDE_FACE_NO_SLIP);
  }

  template <class Run>
  void step(Run& gas, int n, double dt = 5e-4) const {
    const Index nx = gas.mesh.cells[0], nz = gas.mesh.cells[2];
    for (Index c = 0; c < gas.mesh.cell_count; ++c) {
      const bool bed = c / (nx * gas.mesh.cells[1]) < nz / 3;
      gas.gas_fraction[u(c)] = bed ? 0.5 + 0.04 * std::sin(0.2 * n + static_cast<double>(c % nx)) : 0.99;
      gas.exchange[u(c)] = (bed ? 5500 : 30) * units.exchange;
      for (std::size_t a = 0; a < 3; ++a) {
        const std::size_t row = a * u(gas.mesh.cell_count) + u(c);
        gas.exchange_velocity[row] = gas.exchange[u(c)] * 0.1 * units.velocity() * std::sin(static_cast<double>(c) + 0.1 * n);
      }
    }
    if (n == 0) gas.gas_fraction_old = gas.gas_fraction;
    gas.advance(dt * units.time);
  }

  Units units;
  Box box;
};

}  // namespace similitude::test
