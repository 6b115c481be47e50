#pragma once
/// A small bed for the coupling's tests: a box of cells, scattered particles, a drag law of a few lines.

#include <cmath>
#include <cstdint>
#include <numbers>
#include <random>
#include <string>

#include "coupling/coupling.h"
#include "fluid/grid.h"
#include "loader/catalogue.h"
#include "particles/store.h"
#include "scene/scene.h"

namespace similitude::testing {

/// Stokes drag with a crowding factor, K = 3 pi mu d (1 + rho |u-v| d / mu) / eps^2: any smooth law will do.
struct PlainDrag {
  static void exchange(const void*, const similitude_drag_block* b, similitude_status*) {
    for (std::uint32_t n = 0; n < b->rows; ++n) {
      const double reynolds = b->gas_density[n] * b->slip_speed[n] * b->diameter[n] / b->gas_viscosity[n];
      b->exchange[n] = 3 * std::numbers::pi * b->gas_viscosity[n] * b->diameter[n] * (1 + reynolds) /
                       (b->gas_fraction[n] * b->gas_fraction[n]);
    }
  }
};

/// A drag model from plain functions, as if a plugin had been loaded.
class DragFromFunctions {
 public:
  using Exchange = void (*)(const void*, const similitude_drag_block*, similitude_status*);
  using Needs = void (*)(const void*, similitude_drag_needs*);
  explicit DragFromFunctions(Exchange exchange = PlainDrag::exchange, Needs needs = nullptr) {
    functions_.struct_size = sizeof functions_;
    functions_.needs = needs;
    functions_.exchange = exchange;
    descriptor_.struct_size = sizeof descriptor_;
    descriptor_.kind = "drag";
    descriptor_.id = "plain";
    descriptor_.functions = &functions_;
    descriptor_.destroy = [](void*) {};
    model_ = DragModel(descriptor_, this);
  }
  DragFromFunctions(const DragFromFunctions&) = delete;
  DragFromFunctions& operator=(const DragFromFunctions&) = delete;
  const DragModel& model() const { return model_; }

 private:
  similitude_drag_functions functions_{};
  similitude_descriptor descriptor_{};
  DragModel model_;
};

/// Cells 8 x 6 x 11 of 5 x 4 x 6 mm, air, 4 mm particles that are nearly as large as the cells.
inline ModelScene small_scene() {
  ModelScene scene;
  scene.cell = {5e-3, 4e-3, 6e-3};
  scene.size = {8 * 5e-3, 6 * 4e-3, 11 * 6e-3};
  scene.gas_density = 1.2;
  scene.gas_viscosity = 1.8e-5;
  ParticleClass type;
  type.name = "grain";
  type.diameter = type.drag_diameter = type.material_diameter = 4e-3;
  type.density = 1000;
  scene.particles = {type};
  return scene;
}

/// A plate normal to x between cells 3 and 4, from the floor to two cells below the top, over the whole depth.
inline Baffle plate_across(const ModelScene& scene) {
  Baffle plate;
  plate.name = "plate";
  plate.normal = Axis::x;
  plate.position = 4 * scene.cell[0];
  plate.extent = {Interval{plate.position, plate.position}, Interval{0, scene.size[1]}, Interval{0, scene.size[2]}};
  return plate;
}

inline double mass_of(const ParticleClass& type) {
  return type.density * std::numbers::pi / 6 * type.diameter * type.diameter * type.diameter;
}

/// Adds a particle of class 0 with a velocity.
inline void add(ParticleStore& particles, const ModelScene& scene, std::array<double, 3> at, std::array<double, 3> v = {}) {
  const ParticleClass& type = scene.particles[0];
  const std::size_t p = particles.add(particles.size(), 0, at[0], at[1], at[2], type.diameter / 2, mass_of(type));
  particles.velocity[p].x = v[0];
  particles.velocity[p].y = v[1];
  particles.velocity[p].z = v[2];
}

/// Particles anywhere in the box, corners included, with velocities up to `speed`.
inline ParticleStore scattered(const ModelScene& scene, int count, double speed = 1, unsigned seed = 7) {
  ParticleStore particles(StoreFields{.rotation = false, .coupling = true});
  std::mt19937_64 random(seed);
  std::uniform_real_distribution<double> unit(0, 1), both(-1, 1);
  for (int n = 0; n < count; ++n) {
    const std::array<double, 3> at{unit(random) * scene.size[0], unit(random) * scene.size[1], unit(random) * scene.size[2]};
    add(particles, scene, at, {speed * both(random), speed * both(random), speed * both(random)});
  }
  return particles;
}

/// Gas fields without any symmetry.
inline GasFields rough_gas(const Grid& grid, double speed = 2, double force = 500, unsigned seed = 3) {
  GasFields gas;
  const std::size_t cells = grid.cell_count();
  std::mt19937_64 random(seed);
  std::uniform_real_distribution<double> both(-1, 1);
  gas.velocity.resize(3 * cells);
  gas.pressure.resize(cells);
  gas.stress_force.resize(3 * cells);
  for (double& u : gas.velocity) u = speed * both(random);
  for (double& f : gas.stress_force) f = force * both(random);
  return gas;
}

inline GasFields gas_at_rest(const Grid& grid) { return rough_gas(grid, 0, 0); }

/// [m^3], sum over cells of (1 - eps) V.
inline double solids_volume(const Coupling& coupling, const Grid& grid) {
  double sum = 0;
  for (const double eps : coupling.fields().gas_fraction) sum += (1 - eps) * grid.cell_volume();
  return sum;
}

inline double particle_volume(const ParticleStore& particles) {
  double sum = 0;
  for (const Row& r : particles.position) sum += 4.0 / 3 * std::numbers::pi * r.w * r.w * r.w;
  return sum;
}

}  // namespace similitude::testing
