#pragma once
/// Small beds for tests: scenes, stores, random numbers that are the same everywhere.

#include <array>
#include <cmath>
#include <cstdint>
#include <map>

#include "particles/engine.h"
#include "spring_law.h"

namespace similitude::testing {

constexpr double k_pi = 3.14159265358979323846;
constexpr double k_diameter = 1e-3;   // [m]
constexpr double k_density = 1040;    // [kg/m^3]
inline double sphere_mass(double radius) { return k_density * 4 / 3 * k_pi * radius * radius * radius; }

inline ModelScene box(double x, double y, double z, std::array<bool, 3> periodic = {}) {
  ModelScene scene;
  scene.size = {x, y, z};
  scene.periodic = periodic;
  return scene;
}

inline EngineOptions options(double dt, double gravity = 0) {
  EngineOptions out;
  out.dt = dt;
  out.gravity = {0, 0, -gravity};
  return out;
}

inline ParticleStore spinning_store() { return ParticleStore({.rotation = true, .coupling = false}); }

inline std::size_t add_sphere(ParticleStore& store, double x, double y, double z, double radius = 0.5 * k_diameter) {
  return store.add(store.size(), 0, x, y, z, radius, sphere_mass(radius));
}

inline std::size_t row_of(const ParticleStore& store, std::uint64_t id) {
  for (std::size_t row = 0; row < store.size(); ++row) {
    if (store.id[row] == id) return row;
  }
  return store.size();
}

/// Uniform in [0, 1).
class Random {
 public:
  explicit Random(std::uint64_t seed) : state_(seed * 2654435769u + 1) {}
  double next() {
    state_ = state_ * 6364136223846793005u + 1442695040888963407u;
    return static_cast<double>(state_ >> 11) * 0x1p-53;
  }
  double within(double low, double high) { return low + (high - low) * next(); }

 private:
  std::uint64_t state_;
};

/// A jittered lattice that fills the box from the bottom.
inline void fill_lattice(ParticleStore& store, const ModelScene& scene, std::size_t count, double radius, double pitch,
                         double jitter, std::uint64_t seed = 1) {
  Random random(seed);
  const auto nx = static_cast<std::size_t>(scene.size[0] / pitch), ny = static_cast<std::size_t>(scene.size[1] / pitch);
  const double ax = scene.size[0] / static_cast<double>(nx), ay = scene.size[1] / static_cast<double>(ny);
  for (std::size_t n = 0; n < count; ++n) {
    add_sphere(store, (static_cast<double>(n % nx) + 0.5) * ax + random.within(-jitter, jitter),
               (static_cast<double>(n / nx % ny) + 0.5) * ay + random.within(-jitter, jitter),
               (static_cast<double>(n / (nx * ny)) + 0.5) * pitch + random.within(-jitter, jitter), radius);
  }
}

inline void stir(ParticleStore& store, double speed, std::uint64_t seed = 2) {
  Random random(seed);
  for (Row& v : store.velocity) {
    v = {random.within(-speed, speed), random.within(-speed, speed), random.within(-speed, speed), v.w};
  }
}

/// A stirred bed with a plate, a periodic direction and an outlet: everything that lists and orders depend on.
struct MovingBed {
  explicit MovingBed(const SpringLaw& spring) : scene(box(0.04, 0.012, 0.0135, {false, true, false})), law(make_law(spring)) {
    Patch top;
    top.kind = PatchKind::pressure;
    top.face = {Axis::z, Side::high};
    top.extent = {Interval{0, 0.04}, Interval{0, 0.012}, Interval{0.0135, 0.0135}};
    scene.patches.push_back(top);
    Baffle plate;
    plate.position = 0.02;
    plate.thickness = 0.5e-3;
    plate.extent = {Interval{0.02, 0.02}, Interval{0, 0.012}, Interval{0.004, 0.012}};
    scene.baffles.push_back(plate);
  }
  ParticleStore filled() const {
    ParticleStore store = spinning_store();
    fill_lattice(store, scene, 4000, 0.5 * k_diameter, 1.1e-3, 0.02e-3);
    stir(store, 0.5);
    return store;
  }
  ModelScene scene;
  ContactModel law;
};

}  // namespace similitude::testing
