/// Momentum between particles and gas: adjointness, the ledger, what a particle beside a plate feels.

#include <gtest/gtest.h>

#include "bed.h"
#include "particles/errors.h"

namespace similitude::testing {
namespace {

using Vector = std::array<double, 3>;

ModelScene walled_scene() {
  ModelScene scene = small_scene();
  Baffle plate = plate_across(scene);
  plate.extent[2] = {2 * scene.cell[2], 7 * scene.cell[2]};
  scene.baffles = {plate};
  scene.periodic = {false, true, false};
  scene.smoothing_length = 12e-3;
  return scene;
}

double part(const Row& r, std::size_t axis) { return axis == 0 ? r.x : axis == 1 ? r.y : r.z; }

// sum over particles of K u = sum over cells of E u V, axis by axis: to rounding, measured against the sum of magnitudes.
TEST(Exchange, InterpolationIsTheAdjointOfTheDepositForDrag) {
  const ModelScene scene = walled_scene();
  const Grid grid(scene);
  const DragFromFunctions drag;
  Coupling coupling(scene, grid, drag.model(), true);
  ParticleStore particles = scattered(scene, 400);
  const GasFields before = rough_gas(grid), after = rough_gas(grid, 3, 800, 11);
  coupling.start(particles);
  coupling.deposit(particles, before, 1e-4);
  coupling.interpolate(particles, after, 1e-4);
  const std::size_t cells = grid.cell_count();
  for (std::size_t axis = 0; axis < 3; ++axis) {
    double on_particles = 0, on_gas = 0, size = 0;
    for (const Row& r : particles.gas) on_particles += r.w * part(r, axis);
    for (std::size_t c = 0; c < cells; ++c) {
      const double f = coupling.fields().exchange[c] * after.velocity[axis * cells + c] * grid.cell_volume();
      on_gas += f;
      size += std::abs(f);
    }
    EXPECT_NEAR(on_particles, on_gas, 1e-13 * size);
  }
}

// sum over particles of V_p (grad p)_p = sum over cells of phi (grad p) V, with phi the deposited solids fraction.
TEST(Exchange, InterpolationIsTheAdjointOfTheDepositForPressure) {
  ModelScene scene = walled_scene();
  scene.gas_density = 0;   // no buoyancy: the stress force alone
  const Grid grid(scene);
  const DragFromFunctions drag([](const void*, const similitude_drag_block* b, similitude_status*) {
    for (std::uint32_t n = 0; n < b->rows; ++n) b->exchange[n] = 0;
  });
  Coupling coupling(scene, grid, drag.model(), true);
  ParticleStore particles = scattered(scene, 400);
  const GasFields gas = rough_gas(grid);
  coupling.start(particles);
  coupling.deposit(particles, gas, 1e-4);
  coupling.interpolate(particles, gas, 1e-4);
  const std::size_t cells = grid.cell_count();
  for (std::size_t axis = 0; axis < 3; ++axis) {
    double on_particles = 0, on_gas = 0, size = 0;
    for (const Row& f : particles.stress_force) on_particles += part(f, axis);
    for (std::size_t c = 0; c < cells; ++c) {
      const double f = (1 - coupling.fields().gas_fraction[c]) * gas.stress_force[axis * cells + c] * grid.cell_volume();
      on_gas += f;
      size += std::abs(f);
    }
    EXPECT_NEAR(on_particles, on_gas, 1e-13 * size);
  }
}

// Model B divides K by the gas fraction each particle sees, and charges the gas the same.
TEST(Exchange, DividesTheDragByTheGasFractionWhereTheGasCarriesTheStress) {
  const ModelScene scene = walled_scene();
  const Grid grid(scene);
  const DragFromFunctions drag([](const void*, const similitude_drag_block* b, similitude_status*) {
    for (std::uint32_t n = 0; n < b->rows; ++n) b->exchange[n] = b->gas_fraction[n];   // K/eps = 1
  });
  Coupling coupling(scene, grid, drag.model(), true, DragForm::over_gas_fraction);
  ParticleStore particles = scattered(scene, 400);
  coupling.start(particles);
  coupling.deposit(particles, rough_gas(grid), 1e-4);
  double charged = 0;
  for (std::size_t c = 0; c < grid.cell_count(); ++c) charged += coupling.fields().exchange[c] * grid.cell_volume();
  for (const Row& gas : particles.gas) EXPECT_NEAR(gas.w, 1, 1e-15);
  EXPECT_NEAR(charged, 400, 1e-12 * 400);
}

TEST(Exchange, UniformGasIsUniformAtParticles) {
  const ModelScene scene = walled_scene();
  const Grid grid(scene);
  const DragFromFunctions drag;
  Coupling coupling(scene, grid, drag.model(), true);
  ParticleStore particles = scattered(scene, 200);
  GasFields gas = gas_at_rest(grid);
  const std::size_t cells = grid.cell_count();
  for (std::size_t n = 0; n < 3 * cells; ++n) gas.velocity[n] = n < cells ? 0.25 : n < 2 * cells ? -1.5 : 13.2;
  coupling.start(particles);
  coupling.deposit(particles, gas, 1e-4);
  coupling.interpolate(particles, gas, 1e-4);
  for (const Row& u : particles.gas) {
    EXPECT_NEAR(u.x, 0.25, 1e-15);   // eight weights that sum to 1 within two units in the last place
    EXPECT_NEAR(u.y, -1.5, 1e-15);
    EXPECT_NEAR(u.z, 13.2, 1e-14);
  }
}

TEST(Exchange, ParticlesInAGasAtRestFeelTheirBuoyancy) {
  const ModelScene scene = small_scene();
  const Grid grid(scene);
  const DragFromFunctions drag;
  Coupling coupling(scene, grid, drag.model(), true);
  ParticleStore particles = scattered(scene, 10, 0);
  const GasFields gas = gas_at_rest(grid);
  coupling.start(particles);
  coupling.deposit(particles, gas, 1e-4);
  coupling.interpolate(particles, gas, 1e-4);
  const double weight_of_gas = 1.2 * 9.81 * std::numbers::pi / 6 * std::pow(4e-3, 3);   // [N]
  for (const Row& f : particles.stress_force) {
    EXPECT_NEAR(f.z, weight_of_gas, 1e-14 * weight_of_gas);
    EXPECT_EQ(f.x, 0);
  }
}

// A parcel stands for `weight` particles of the drag diameter and occupies the sphere it touches with.
TEST(Exchange, AParcelCarriesTheDragAndTheBuoyancyOfAllItStandsFor) {
  ModelScene scene = small_scene();
  scene.particles[0].drag_diameter = 2e-3;
  scene.particles[0].weight = 8;
  const Grid grid(scene);
  const DragFromFunctions drag([](const void*, const similitude_drag_block* b, similitude_status*) {
    for (std::uint32_t n = 0; n < b->rows; ++n) b->exchange[n] = b->diameter[n];
  });
  Coupling coupling(scene, grid, drag.model(), true);
  ParticleStore particles = scattered(scene, 30, 0);
  const GasFields gas = gas_at_rest(grid);
  coupling.start(particles);
  coupling.deposit(particles, gas, 1e-4);
  coupling.interpolate(particles, gas, 1e-4);
  EXPECT_DOUBLE_EQ(particles.gas[3].w, 8 * 2e-3);
  EXPECT_NEAR(particles.stress_force[3].z / (1.2 * 9.81 * 8 * std::numbers::pi / 6 * std::pow(2e-3, 3)), 1, 1e-14);
  EXPECT_NEAR(solids_volume(coupling, grid) / particle_volume(particles), 1, 1e-12);
}

/// A gas of cells that answers with implicit drag, and particles that feel the drag in sub-steps with K held: momentum of
/// both, and of what is on the way, must not change when nothing else acts.
class Ledger : public ::testing::Test {
 protected:
  void gas_step(Coupling& coupling) {
    const ExchangeFields& f = coupling.fields();
    for (std::size_t n = 0; n < 3 * cells; ++n) {
      const std::size_t c = n % cells;
      const double density = 1.2 * f.gas_fraction[c];
      const double before = gas.velocity[n];
      gas.velocity[n] = (density * before + dt * (f.exchange_velocity[n] + f.remainder[n])) / (density + dt * f.exchange[c]);
      momentum_of_gas[n / cells] += grid.cell_volume() * density * (gas.velocity[n] - before);
      exchanged += std::abs(grid.cell_volume() * density * (gas.velocity[n] - before));
    }
  }
  void sub_steps(ParticleStore& particles, int count) {
    const double h = dt / count;
    for (std::size_t p = 0; p < particles.size(); ++p) {
      const Row u = particles.gas[p];
      Row &v = particles.velocity[p], &x = particles.position[p], &impulse = particles.drag_impulse[p];
      for (int n = 0; n < count; ++n) {
        const double share = u.w * h / (1 + u.w * h / v.w);
        const double jx = share * (u.x - v.x), jy = share * (u.y - v.y), jz = share * (u.z - v.z);
        impulse.x += jx, impulse.y += jy, impulse.z += jz;
        v.x += jx / v.w, v.y += jy / v.w, v.z += jz / v.w;
        x.x += h * v.x, x.y += h * v.y, x.z += h * v.z;
      }
    }
  }
  Vector momentum(const ParticleStore& particles) const {
    Vector sum = momentum_of_gas;
    for (const Row& v : particles.velocity) sum[0] += v.w * v.x, sum[1] += v.w * v.y, sum[2] += v.w * v.z;
    return sum;
  }

  ModelScene scene = walled_scene();
  Grid grid{scene};
  DragFromFunctions drag;
  std::size_t cells = grid.cell_count();
  GasFields gas = rough_gas(grid, 5, 0);
  double dt = 1e-3;                 // [s]
  Vector momentum_of_gas{};         // [kg m/s], change since the start
  double exchanged = 0;             // [kg m/s], sum of magnitudes: the scale of rounding
};

TEST_F(Ledger, ClosesOverManyStepsWithImplicitGasAndSubSteps) {
  Coupling coupling(scene, grid, drag.model(), true);
  ParticleStore particles = scattered(scene, 400, 1);
  coupling.start(particles);
  const Vector before = momentum(particles);
  for (int step = 0; step < 25; ++step) {
    coupling.deposit(particles, gas, dt);
    gas_step(coupling);
    coupling.interpolate(particles, gas, dt);
    sub_steps(particles, 7);
    coupling.settle_accounts(particles);
    const Vector after = momentum(particles), pending = coupling.pending_momentum();
    for (std::size_t axis = 0; axis < 3; ++axis) {
      EXPECT_NEAR(after[axis] + pending[axis], before[axis], 1e-12 * exchanged) << "step " << step;
    }
  }
  // The test would be idle if estimate and truth agreed anyway.
  EXPECT_GT(std::abs(coupling.pending_momentum()[0]) + std::abs(coupling.pending_momentum()[2]), 1e-6 * exchanged);
}

TEST_F(Ledger, HoldsTheChargeBetweenTheGasStepAndTheSubSteps) {
  Coupling coupling(scene, grid, drag.model(), true);
  ParticleStore particles = scattered(scene, 400, 1);
  coupling.start(particles);
  const Vector before = momentum(particles);
  coupling.deposit(particles, gas, dt);
  gas_step(coupling);
  coupling.interpolate(particles, gas, dt);
  const Vector after = momentum(particles), pending = coupling.pending_momentum();
  for (std::size_t axis = 0; axis < 3; ++axis) EXPECT_NEAR(after[axis] + pending[axis], before[axis], 1e-12 * exchanged);
}

TEST_F(Ledger, SurvivesASortOfTheRows) {
  Coupling coupling(scene, grid, drag.model(), true);
  ParticleStore particles = scattered(scene, 400, 1);
  coupling.start(particles);
  const Vector before = momentum(particles);
  for (int step = 0; step < 6; ++step) {
    coupling.deposit(particles, gas, dt);
    gas_step(coupling);
    coupling.interpolate(particles, gas, dt);
    std::vector<std::uint32_t> backwards(particles.size());
    for (std::uint32_t n = 0; n < backwards.size(); ++n) backwards[n] = static_cast<std::uint32_t>(backwards.size()) - 1 - n;
    particles.reorder(backwards);
    sub_steps(particles, 3);
    coupling.settle_accounts(particles);
  }
  const Vector after = momentum(particles), pending = coupling.pending_momentum();
  for (std::size_t axis = 0; axis < 3; ++axis) EXPECT_NEAR(after[axis] + pending[axis], before[axis], 1e-12 * exchanged);
}

TEST_F(Ledger, CountsParticlesThatLeaveWithAnOpenAccount) {
  Coupling coupling(scene, grid, drag.model(), true);
  ParticleStore particles = scattered(scene, 40, 1);
  coupling.start(particles);
  coupling.deposit(particles, gas, dt);
  coupling.interpolate(particles, gas, dt);
  std::vector<std::uint32_t> rest(37);
  for (std::uint32_t n = 0; n < 37; ++n) rest[n] = n + 3;
  particles.reorder(rest);
  coupling.settle_accounts(particles);
  EXPECT_EQ(coupling.accounts_left(), 3u);
}

// The solver's stress force is one-sided at a plate: big on the left, nothing on the right, and nothing along x. Neither
// tent nor smoothing may carry one side's force to particles that lean against the other.
TEST(Exchange, ParticlesBesideAPlateFeelTheirOwnSideOnly) {
  ModelScene scene = small_scene();
  scene.gas_density = 0;
  scene.smoothing_length = 30e-3;
  scene.baffles = {plate_across(scene)};
  const Grid grid(scene);
  const DragFromFunctions drag;
  Coupling coupling(scene, grid, drag.model(), true);
  ParticleStore particles(StoreFields{.rotation = false, .coupling = true});
  const double plate = 4 * scene.cell[0];
  for (const double side : {-1.0, 1.0}) {
    for (int n = 0; n < 10; ++n) add(particles, scene, {plate + side * 2e-3, 12e-3, 3e-3 + n * 6e-3});
  }
  GasFields gas = gas_at_rest(grid);
  const std::size_t cells = grid.cell_count();
  for (std::size_t c = 0; c < cells; ++c) gas.stress_force[2 * cells + c] = c % 8 < 4 ? 1000.0 : 0.0;
  coupling.start(particles);
  coupling.deposit(particles, gas, 1e-4);
  coupling.interpolate(particles, gas, 1e-4);
  const double volume = std::numbers::pi / 6 * std::pow(4e-3, 3);
  for (std::size_t p = 0; p < particles.size(); ++p) {
    EXPECT_EQ(particles.stress_force[p].x, 0);
    EXPECT_NEAR(particles.stress_force[p].z, p < 10 ? 1000 * volume : 0, 1e-14 * 1000 * volume);
  }
}

TEST(Exchange, AGivenGasIsNeitherChargedNorSmoothed) {
  const ModelScene scene = walled_scene();
  const Grid grid(scene);
  const DragFromFunctions drag;
  Coupling coupling(scene, grid, drag.model(), false);
  ParticleStore particles(StoreFields{.rotation = false, .coupling = true});
  add(particles, scene, {2.5 * scene.cell[0], 3.5 * scene.cell[1], 4.5 * scene.cell[2]});
  const GasFields gas = rough_gas(grid);
  coupling.start(particles);
  coupling.deposit(particles, gas, 1e-4);
  coupling.interpolate(particles, gas, 1e-4);
  const std::size_t cells = grid.cell_count(), here = grid.cell(2, 3, 4);
  EXPECT_NEAR(particles.gas[0].y, gas.velocity[cells + here], 1e-14);
  EXPECT_GT(particles.gas[0].w, 0);
  EXPECT_EQ(particles.drag_impulse[0].x, 0);
  for (const double eps : coupling.fields().gas_fraction) EXPECT_EQ(eps, 1);
  for (const double e : coupling.fields().exchange) EXPECT_EQ(e, 0);
  for (const double r : coupling.fields().remainder) EXPECT_EQ(r, 0);
}

TEST(Exchange, GasFractionOldIsTheLastStepsGasFraction) {
  const ModelScene scene = walled_scene();
  const Grid grid(scene);
  const DragFromFunctions drag;
  Coupling coupling(scene, grid, drag.model(), true);
  ParticleStore particles = scattered(scene, 100);
  const GasFields gas = gas_at_rest(grid);
  coupling.start(particles);
  const auto first = coupling.fields().gas_fraction;
  EXPECT_EQ(coupling.fields().gas_fraction_old, first);
  for (Row& x : particles.position) x.z *= 0.9;
  coupling.deposit(particles, gas, 1e-4);
  EXPECT_EQ(coupling.fields().gas_fraction_old, first);
  EXPECT_NE(coupling.fields().gas_fraction, first);
  std::size_t cell = 0;
  const double smallest = coupling.smallest_gas_fraction(&cell);
  EXPECT_EQ(coupling.fields().gas_fraction[cell], smallest);
  EXPECT_LT(smallest, 1);
}

// d32 = sum d^3 / sum d^2 of what the solids around are; of one size it is that size.
TEST(Exchange, GivesTheLawTheSauterDiameterAndTheCellSizeIfItAsks) {
  ModelScene scene = small_scene();
  scene.smoothing_length = 200e-3;   // so wide that the whole box is one mixture
  scene.particles.push_back(scene.particles[0]);
  scene.particles[1].diameter = scene.particles[1].drag_diameter = 2e-3;
  const Grid grid(scene);
  static double sauter_seen = 0, cell_seen = 0;
  const DragFromFunctions drag(
      [](const void*, const similitude_drag_block* b, similitude_status*) {
        sauter_seen = b->sauter_diameter[0];
        cell_seen = b->cell_size[0];
        for (std::uint32_t n = 0; n < b->rows; ++n) b->exchange[n] = 0;
      },
      [](const void*, similitude_drag_needs* needs) { needs->sauter_diameter = needs->cell_size = 1; });
  Coupling coupling(scene, grid, drag.model(), true);
  ParticleStore particles(StoreFields{.rotation = false, .coupling = true});
  particles.add(0, 0, 20e-3, 12e-3, 30e-3, 2e-3, 1e-5);
  for (std::uint64_t n = 0; n < 4; ++n) particles.add(n + 1, 1, 20e-3, 12e-3, 30e-3, 1e-3, 1e-6);
  const GasFields gas = gas_at_rest(grid);
  coupling.start(particles);
  coupling.deposit(particles, gas, 1e-4);
  EXPECT_NEAR(sauter_seen, (64 + 4 * 8) / (16.0 + 4 * 4) * 1e-3, 1e-15);
  EXPECT_DOUBLE_EQ(cell_seen, std::cbrt(5e-3 * 4e-3 * 6e-3));
}

TEST(Exchange, AnEmptyBedIsAnEmptyGas) {
  const ModelScene scene = walled_scene();
  const Grid grid(scene);
  const DragFromFunctions drag;
  Coupling coupling(scene, grid, drag.model(), true);
  ParticleStore particles(StoreFields{.rotation = false, .coupling = true});
  const GasFields gas = rough_gas(grid);
  coupling.start(particles);
  coupling.deposit(particles, gas, 1e-4);
  coupling.interpolate(particles, gas, 1e-4);
  coupling.settle_accounts(particles);
  EXPECT_EQ(coupling.smallest_gas_fraction(nullptr), 1);
  EXPECT_EQ(coupling.pending_momentum(), (Vector{0, 0, 0}));
}

template <class Action>
std::string text_of_error(Action&& action) {
  try {
    action();
  } catch (const SimulationError& error) {
    return error.what();
  }
  return "no error";
}

TEST(Exchange, PassesOnTheLawsOwnWordsWithTheParticle) {
  const ModelScene scene = small_scene();
  const Grid grid(scene);
  const DragFromFunctions drag([](const void*, const similitude_drag_block*, similitude_status* status) {
    status->code = 7;
    status->row = 2;
    std::snprintf(status->text, sizeof status->text, "the gas fraction is out of range");
  });
  Coupling coupling(scene, grid, drag.model(), true);
  ParticleStore particles(StoreFields{.rotation = false, .coupling = true});
  for (int n = 1; n <= 3; ++n) add(particles, scene, {n * 5e-3, 8e-3, 12e-3});
  coupling.start(particles);
  EXPECT_EQ(text_of_error([&] { coupling.deposit(particles, gas_at_rest(grid), 1e-4); }),
            "the drag law \"plain\" failed at particle 2 at (0.015, 0.008, 0.012) m: the gas fraction is out of range.\n"
            "  Lengths are the simulated bed's. Is the gas step too long, or the bed denser than the law allows?");
}

TEST(Exchange, RefusesAnExchangeCoefficientThatIsNotANumber) {
  const ModelScene scene = small_scene();
  const Grid grid(scene);
  const DragFromFunctions drag([](const void*, const similitude_drag_block* b, similitude_status*) {
    for (std::uint32_t n = 0; n < b->rows; ++n) b->exchange[n] = n == 1 ? -2.0 : 1.0;
  });
  Coupling coupling(scene, grid, drag.model(), true);
  ParticleStore particles(StoreFields{.rotation = false, .coupling = true});
  for (int n = 1; n <= 3; ++n) add(particles, scene, {n * 5e-3, 8e-3, 12e-3}, {0, 0, 0.5});
  coupling.start(particles);
  const std::string text = text_of_error([&] { coupling.deposit(particles, gas_at_rest(grid), 1e-4); });
  EXPECT_EQ(text.rfind("the drag law \"plain\" failed at particle 1 at (0.01, 0.008, 0.012) m: its K is -2 kg/s where the gas "
                       "fraction is 0.",
                       0),
            0u)
      << text;
}

// Two beds whose dimensionless groups agree and whose ratios are powers of two: the same bits, scaled.
TEST(Exchange, ABedScaledByPowersOfTwoHasTheSameBits) {
  const double length = 0.25, time = 0.5, density = 4;   // with viscosity = density length^2 / time the groups agree
  const double speed = length / time;
  ModelScene real = walled_scene(), scaled = real;
  for (std::size_t a = 0; a < 3; ++a) {
    scaled.cell[a] *= length;
    scaled.size[a] *= length;
    for (std::size_t b = 0; b < 1; ++b) {
      scaled.baffles[b].extent[a].low *= length;
      scaled.baffles[b].extent[a].high *= length;
    }
  }
  scaled.baffles[0].position *= length;
  *scaled.smoothing_length *= length;
  scaled.gas_density *= density;
  scaled.gas_viscosity *= density * length * length / time;
  scaled.gravity[2] *= speed / time;
  ParticleClass& type = scaled.particles[0];
  type.diameter *= length, type.drag_diameter *= length, type.density *= density;

  const DragFromFunctions drag;
  const Grid grid(real), grid_scaled(scaled);
  Coupling a(real, grid, drag.model(), true), b(scaled, grid_scaled, drag.model(), true);
  ParticleStore p = scattered(real, 300), q = p;
  for (std::size_t n = 0; n < q.size(); ++n) {
    q.position[n] = {p.position[n].x * length, p.position[n].y * length, p.position[n].z * length, p.position[n].w * length};
    q.velocity[n] = {p.velocity[n].x * speed, p.velocity[n].y * speed, p.velocity[n].z * speed,
                     p.velocity[n].w * density * length * length * length};
  }
  GasFields gas = rough_gas(grid), gas_scaled = gas;
  for (double& u : gas_scaled.velocity) u *= speed;
  for (double& f : gas_scaled.stress_force) f *= density * speed / time;
  a.start(p);
  b.start(q);
  for (int step = 0; step < 2; ++step) {
    a.deposit(p, gas, 1e-3);
    a.interpolate(p, gas, 1e-3);
    a.settle_accounts(p);
    b.deposit(q, gas_scaled, 1e-3 * time);
    b.interpolate(q, gas_scaled, 1e-3 * time);
    b.settle_accounts(q);
  }
  const double per_time = density / time, force = density * speed / time;
  for (std::size_t c = 0; c < grid.cell_count(); ++c) {
    ASSERT_EQ(a.fields().gas_fraction[c], b.fields().gas_fraction[c]);
    ASSERT_EQ(a.fields().exchange[c] * per_time, b.fields().exchange[c]);
    ASSERT_EQ(a.fields().remainder[c] * force, b.fields().remainder[c]);
  }
  const double newton = force * length * length * length;
  for (std::size_t n = 0; n < p.size(); ++n) {
    ASSERT_EQ(p.gas[n].x * speed, q.gas[n].x);
    ASSERT_EQ(p.stress_force[n].z * newton, q.stress_force[n].z);
    ASSERT_EQ(p.drag_impulse[n].y * newton * time, q.drag_impulse[n].y);
  }
}

}  // namespace
}  // namespace similitude::testing
