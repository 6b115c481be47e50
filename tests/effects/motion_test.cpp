/// Effects on particles in their gas: added mass and lift, against closed forms.

#include <gtest/gtest.h>

#include "columns.h"
#include "coupling/effect_pass.h"
#include "effect_case.h"

namespace similitude::test {
namespace {

EffectCase foam_in_water() {
  return {.diameter = 2e-3, .density = 100, .gas_density = 1000, .gas_viscosity = 1e-3,
          .contact = "{id: linear_spring, stiffness: 1000 N/m, restitution: 0.5, friction: 0}", .effects = "[virtual_mass]", .dt = 1e-6};
}

// A sphere released in a liquid at rest: (m + m_a) a = (rho_f - rho_p) V g, so a = (1 - 0.1)/(0.1 + 0.5) g = 1.5 g where it
// would be 9 g without added mass. After 0.1 ms it moves at 1.5 mm/s; Stokes' drag 3 pi mu d v is then 1e-3 of the
// driving force, and by the mean over the time it takes half of that off the velocity.
TEST(VirtualMass, ALightSphereStartsAtOneAndAHalfG) {
  const auto bed = foam_in_water().with({{.place = {0.02, 0.02, 0.02}}});
  run_until(*bed, 1e-4);
  const double time = bed->simulation->time(), expected = 0.9 / 0.6 * 9.81 * time;
  const double drag_share = 0.5 * 3 * k_pi * 1e-3 * 2e-3 * expected / (900 * k_pi / 6 * 8e-9 * 9.81);
  EXPECT_NEAR(bed->simulation->particles().velocity[0].z, expected, 2 * drag_share * expected);
  EXPECT_LT(drag_share, 1e-3);
}

// Density ratio 0.1, where an explicit added-mass force would multiply itself by -5 from step to step. v_t from
// C_D Re^2 = 4/3 Ar with Schiller-Naumann: 192 mm/s.
TEST(VirtualMass, ALightSphereRisesSmoothlyToItsTerminalVelocity) {
  EffectCase foam = foam_in_water();
  foam.dt = 2e-5;
  const auto bed = foam.with({{.place = {0.02, 0.02, 0.002}}});
  double before = 0;
  while (bed->simulation->time() < 0.12) {
    bed->simulation->step();
    const double now = bed->simulation->particles().velocity[0].z;
    EXPECT_GE(now, before * (1 - 1e-12));
    before = now;
  }
  const double reynolds = 1000 * before * 2e-3 / 1e-3;
  const double drag = 3 * k_pi * 1e-3 * 2e-3 * before * (1 + 0.15 * std::pow(reynolds, 0.687));
  EXPECT_NEAR(drag, 900 * k_pi / 6 * 8e-9 * 9.81, 2e-3 * drag);   // 0.12 s are six relaxation times: e^-6
}

// Newton's third law in a liquid that moves: what spheres and liquid exchange is in both books.
TEST(VirtualMass, ABedOfLightSpheresKeepsItsBooks) {
  EffectCase foam = foam_in_water();
  foam.fluid = "vans";
  foam.dt = 1e-5;
  std::vector<Placed> balls;
  for (int k = 0; k < 6; ++k) {
    for (int j = 0; j < 6; ++j) {
      for (int i = 0; i < 6; ++i) balls.push_back({.place = {0.015 + 2.2e-3 * i, 0.015 + 2.2e-3 * j, 0.015 + 2.2e-3 * k}});
    }
  }
  const auto bed = foam.with(balls);
  run_until(*bed, 0.003);
  const Balances off = bed->simulation->balances();
  EXPECT_LT(off.momentum, 1e-10);
  EXPECT_LT(off.energy, 1e-10);
  EXPECT_GT(bed->simulation->particles().velocity[0].z, 0);
  EXPECT_LT(bed->simulation->particles().velocity[0].z, 0.25);   // [m/s], terminal velocity of a single sphere and a margin
}

/// A particle block of 8 alike rows.
struct Rows {
  Column diameter{8}, mass{8}, fraction{8, 1.0}, density{8}, viscosity{8}, linear{8}, added{8};
  Columns3 velocity{8}, gas_velocity{8}, spin{8}, vorticity{8}, acceleration{8}, force{8};

  Vec3<double> force_of(const EffectModel& effect) {
    similitude_particle_block b{};
    b.struct_size = sizeof b;
    b.rows = 8;
    b.dt = 1e-4;
    b.diameter = diameter.data();
    b.mass = mass.data();
    b.gas_fraction = fraction.data();
    b.gas_density = density.data();
    b.gas_viscosity = viscosity.data();
    b.linear_coefficient = linear.data();
    b.added_mass = added.data();
    for (std::size_t a = 0; a < 3; ++a) {
      b.velocity[a] = velocity.axis[a].data();
      b.gas_velocity[a] = gas_velocity.axis[a].data();
      b.angular_velocity[a] = spin.axis[a].data();
      b.gas_vorticity[a] = vorticity.axis[a].data();
      b.gas_acceleration[a] = acceleration.axis[a].data();
      for (std::size_t row = 0; row < 8; ++row) force.axis[a][row] = linear[row] = added[row] = 0;
      b.force[a] = force.axis[a].data();
    }
    similitude_status status{};
    effect.functions().particles(effect.instance(), &b, &status);
    EXPECT_EQ(status.code, 0) << status.text;
    return force.get(5);
  }
  void all(Column& column, double value) {
    for (std::size_t row = 0; row < 8; ++row) column[row] = value;
  }
  void all(Columns3& columns, const Vec3<double>& value) {
    for (std::size_t row = 0; row < 8; ++row) columns.set(row, value);
  }
};

Rows sphere_in_air() {
  Rows rows;
  rows.all(rows.diameter, 1e-4);
  rows.all(rows.density, 1.2);
  rows.all(rows.viscosity, 1.8e-5);
  return rows;
}

// Saffman (1965, 1968): 6.46 mu a^2 |u - v| sqrt(kappa / nu), a the radius. u = (kappa z, 0, 0): curl u points along y, and a
// sphere that lags is lifted to where the gas is faster.
TEST(SaffmanLift, IsSaffmansInASlowLinearShear) {
  Rows rows = sphere_in_air();
  const double rate = 50, slip = 0.01;
  rows.all(rows.gas_velocity, {slip, 0, 0});
  rows.all(rows.vorticity, {0, rate, 0});
  const double expected = 6.46 * 1.8e-5 * 0.25e-8 * slip * std::sqrt(rate / (1.8e-5 / 1.2));
  const Vec3<double> lift = rows.force_of(effect_model("saffman_lift", {}, {{"correction", "none"}}));
  EXPECT_NEAR(lift.z, expected, 1e-12 * expected);
  EXPECT_EQ(lift.x, 0);
  EXPECT_EQ(lift.y, 0);
}

// Mei (1992) at Re = 6.667 and beta = 0.25: (1 - 0.3314/2) exp(-0.6667) + 0.3314/2 = 0.59404; at Re = 66.67, beta = 0.25:
// 0.0524 sqrt(16.667) = 0.21392.
TEST(SaffmanLift, FallsAsMeiSaysWhereTheSlipIsFast) {
  const auto ratio = [](double slip) {
    Rows rows = sphere_in_air();
    rows.all(rows.gas_velocity, {slip, 0, 0});
    rows.all(rows.vorticity, {0, 0.25 * 2 * slip / 1e-4, 0});
    return rows.force_of(effect_model("saffman_lift")).z / rows.force_of(effect_model("saffman_lift", {}, {{"correction", "none"}})).z;
  };
  EXPECT_NEAR(ratio(1), 0.59404, 1e-5);
  EXPECT_NEAR(ratio(10), 0.21392, 1e-5);
}

TEST(SaffmanLift, IsNothingInAGasThatDoesNotTurn) {
  Rows rows = sphere_in_air();
  rows.all(rows.gas_velocity, {1, 2, 3});
  const Vec3<double> lift = rows.force_of(effect_model("saffman_lift"));
  EXPECT_EQ(lift.x, 0);
  EXPECT_EQ(lift.y, 0);
  EXPECT_EQ(lift.z, 0);
}

// Rubinow & Keller (1961): pi a^3 rho Omega x V of a sphere that moves at V and spins at Omega in a gas at rest.
TEST(MagnusLift, IsRubinowAndKellersInASlowFlow) {
  Rows rows = sphere_in_air();
  rows.all(rows.velocity, {0.1, 0, 0});
  rows.all(rows.spin, {0, 0, 3000});
  const double expected = k_pi * 0.125e-12 * 1.2 * 3000 * 0.1;
  EXPECT_NEAR(rows.force_of(effect_model("magnus_lift", {}, {{"correction", "none"}})).y, expected, 1e-12 * expected);
  EXPECT_NEAR(rows.force_of(effect_model("magnus_lift")).y, expected, 1e-12 * expected);   // Re = 0.67
}

// Re = 100: 0.178 + 0.822 / 100^0.522 = 0.25228.
TEST(MagnusLift, FallsAsLunAndLiuSayWhereTheSlipIsFast) {
  Rows rows = sphere_in_air();
  const double speed = 100 * 1.8e-5 / (1.2 * 1e-4);
  rows.all(rows.velocity, {speed, 0, 0});
  rows.all(rows.spin, {0, 0, 3000});
  const double slow = k_pi * 0.125e-12 * 1.2 * 3000 * speed;
  EXPECT_NEAR(rows.force_of(effect_model("magnus_lift")).y / slow, 0.25228, 1e-5);
}

TEST(MagnusLift, IsNothingForASphereThatTurnsWithItsGas) {
  Rows rows = sphere_in_air();
  rows.all(rows.velocity, {1, 2, 3});
  rows.all(rows.spin, {10, 20, 30});
  rows.all(rows.vorticity, {20, 40, 60});
  EXPECT_EQ(rows.force_of(effect_model("magnus_lift")).y, 0);
}

// The host's side: u = (kappa z, 0, 0) on the grid, a sphere at rest in the middle of it. Differences of linear fields are exact.
TEST(EffectPass, GivesTheVorticityOfTheGasAtTheParticle) {
  EffectCase shear{.diameter = 1e-3, .gas_density = 1.2, .gas_viscosity = 1.8e-5, .effects = "[{id: saffman_lift, correction: none}]"};
  const Assembly assembly = assemble(case_of(shear.yaml()).scene, built_plugins());
  ParticleStore particles(store_fields(assembly));
  particles.add(0, 0, 0.0203, 0.0211, 0.0197, 0.5e-3, shear.mass());
  const Grid& grid = *assembly.grid;
  const double rate = 200, slip = rate * 0.0197;
  GasFields gas;
  gas.velocity.assign(3 * grid.cell_count(), 0);
  for (int k = 0; k < grid.cells(2); ++k) {
    for (int j = 0; j < grid.cells(1); ++j) {
      for (int i = 0; i < grid.cells(0); ++i) gas.velocity[grid.cell(i, j, k)] = rate * (k + 0.5) * grid.spacing(2);
    }
  }
  particles.gas[0] = {slip, 0, 0, 0};
  GasMotion motion(assembly.model, grid, assembly.coupled(), assembly.effect_reads);
  motion.update(gas, 0, 1e-4);
  EffectPass(assembly.model, grid, assembly.effects[0], &motion).apply(particles, similitude::Column<double>(grid.cell_count(), 1.0), 1e-4);
  const double expected = 6.46 * 1.8e-5 * 0.25e-6 * slip * std::sqrt(rate / (1.8e-5 / 1.2));
  EXPECT_NEAR(particles.stress_force[0].z, expected, 1e-9 * expected);
}

}  // namespace
}  // namespace similitude::test
