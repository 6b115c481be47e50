#pragma once
/// A bed that other programs lose, and what it must hold while it runs: every step is watched, not the end alone.

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <numbers>
#include <random>
#include <string>

#include <fmt/format.h>

#include "small_bed.h"

namespace similitude::test {

/// A case file with the parts that hard cases differ by.
struct HardCase {
  std::string size = "[10 mm, 10 mm, 40 mm]", cell = "2.5 mm";
  std::string gas = "density: 1.225 kg/m^3, viscosity: 1.79e-5 Pa s";
  std::string particles = "grain: {diameter: 1 mm, density: 1040 kg/m^3, count: 400}";
  std::string bed = "fill: settle, cache: false";
  std::string patches = "outlet: {face: top, pressure: 0 Pa}";
  std::string scene;                        // further lines of the scene
  std::string drag = "gidaspow";
  std::string contact = "{id: linear_spring, stiffness: 200 N/m, restitution: 0.74, friction: 0.3}";
  std::string fluid = "vans";
  std::string effects = "auto";
  std::string smoothing;                    // a length, or nothing
  std::string time;                         // "dt: …, gas_dt: …"; nothing: auto
};

inline std::string text_of(const HardCase& c) {
  return fmt::format(R"(
similitude: 1
title: a hard case
scene:
  domain:    {{size: {}, cell: {}}}
  gas:       {{{}}}
  particles: {{{}}}
  bed:       {{{}}}
  patches:   {{{}}}
{}
models:
  drag: {}
  contact: {}
  fluid: {}
  scaling: exact
  effects: {}
{}
time: {{end: 1000 s{}{}}}
)",
                     c.size, c.cell, c.gas, c.particles, c.bed, c.patches, c.scene, c.drag, c.contact, c.fluid, c.effects,
                     c.smoothing.empty() ? "" : "coupling: {smoothing: " + c.smoothing + "}", c.time.empty() ? "" : ", ", c.time);
}

/// Spheres of one kind that a test places itself; the case then has `fill: none`.
struct Grain {
  double diameter = 1e-3, density = 1040;   // [m], [kg/m^3]
  double mass() const { return density * std::numbers::pi / 6 * diameter * diameter * diameter; }
  std::size_t add(ParticleStore& store, std::array<double, 3> at, std::array<double, 3> velocity = {}, std::uint32_t species = 0) const {
    const std::size_t row = store.add(store.size(), species, at[0], at[1], at[2], diameter / 2, mass());
    store.velocity[row].x = velocity[0];
    store.velocity[row].y = velocity[1];
    store.velocity[row].z = velocity[2];
    if (store.fields.rotation) store.angular_velocity[row].w = 0.4 * mass() * diameter * diameter / 4;
    return row;
  }
};

/// Steps a bed and keeps the worst that it saw. The guards of a run are on: they throw, and the test fails with their words.
class Watch {
 public:
  explicit Watch(SmallBed& bed) : bed_(bed), particles_(bed.simulation->particles().size()) {}

  void until(double time) { while (bed_.simulation->time() < time) step(); }
  void steps(int count) { for (int n = 0; n < count; ++n) step(); }
  /// As long as it takes to fail: a case that holds must hold for SIMILITUDE_LONGER times as long as well.
  void at_least(double time) { until(time * longer()); }
  static int longer() {
    const char* asked = std::getenv("SIMILITUDE_LONGER");
    return asked != nullptr ? std::atoi(asked) : 1;
  }

  void step() {
    Simulation& simulation = *bed_.simulation;
    simulation.step();
    const EngineReport& report = simulation.engine().report();
    overlap = std::max(overlap, report.largest_overlap.overlap_ratio);
    fastest = std::max(fastest, report.largest_speed);
    courant = std::max(courant, simulation.gas_report().courant);
    mass_residual = std::max(mass_residual, simulation.gas_report().mass_residual);
    for (const double fraction : simulation.exchange().gas_fraction) {
      smallest_gas_fraction = std::min(smallest_gas_fraction, fraction);
      largest_gas_fraction = std::max(largest_gas_fraction, fraction);
    }
    for (const double velocity : simulation.gas().velocity) gas_speed = std::max(gas_speed, std::abs(velocity));
  }

  /// Nothing infinite, nobody lost, everybody inside, the books closed.
  void expect_sound(double deepest_overlap) const {
    const Simulation& simulation = *bed_.simulation;
    const auto& size = bed_.assembly->model.size;
    EXPECT_EQ(simulation.particles().size() + simulation.engine().report().removed, particles_);
    for (std::size_t row = 0; row < simulation.particles().size(); ++row) {
      const Row& x = simulation.particles().position[row];
      const Row& v = simulation.particles().velocity[row];
      ASSERT_TRUE(std::isfinite(v.x) && std::isfinite(v.y) && std::isfinite(v.z));
      const std::array<double, 3> at{x.x, x.y, x.z};
      for (std::size_t a = 0; a < 3; ++a) {
        const double margin = bed_.assembly->model.periodic[a] ? 2 * x.w : 0;   // a seam is crossed, a wall is not
        ASSERT_TRUE(at[a] > -margin && at[a] < size[a] + margin) << "particle at " << at[0] << " " << at[1] << " " << at[2];
      }
    }
    for (const double p : simulation.gas().pressure) ASSERT_TRUE(std::isfinite(p));
    EXPECT_LT(overlap, deepest_overlap);
    EXPECT_LE(largest_gas_fraction, 1 + 1e-12);   // rounding of a sum
    EXPECT_GE(smallest_gas_fraction, 0.25);       // [-], denser than any packing: the guard's 0.10 is where nothing means anything
    const Balances balances = simulation.balances();
    EXPECT_LT(balances.momentum, 1e-10);          // rounding
    EXPECT_LT(balances.energy, 1e-10);
    if (!bed_.assembly->coupled()) return;
    const double tolerance = bed_.assembly->model.models.fluid.id == "porous" ? 1e-6 : 1e-7;   // [-], the solvers' defaults
    EXPECT_LT(mass_residual, 1.01 * tolerance);
    EXPECT_LT(balances.gas_mass, tolerance * static_cast<double>(bed_.assembly->grid->cell_count()));
  }

  double overlap = 0;                                           // [-]
  double fastest = 0, gas_speed = 0;                            // [m/s]
  double courant = 0, mass_residual = 0;                        // [-]
  double smallest_gas_fraction = 1, largest_gas_fraction = 0;   // [-]

 private:
  SmallBed& bed_;
  std::size_t particles_;
};

/// [J], kinetic and of height, of all particles.
inline double mechanical_energy(const Simulation& simulation, double gravity = 9.81) {
  const ParticleStore& particles = simulation.particles();
  double energy = energy_of(particles);
  for (std::size_t row = 0; row < particles.size(); ++row) energy += particles.velocity[row].w * gravity * particles.position[row].z;
  return energy;
}

inline double mean_height(const ParticleStore& particles) {   // [m]
  double sum = 0;
  for (const Row& x : particles.position) sum += x.z;
  return sum / static_cast<double>(particles.size());
}

inline ParticleStore empty_store(bool rotation = true) { return ParticleStore({.rotation = rotation, .coupling = true}); }

}  // namespace similitude::test
