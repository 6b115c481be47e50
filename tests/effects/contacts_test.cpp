/// Effects in contacts: rolling and cohesion, against closed forms.

#include <gtest/gtest.h>

#include <algorithm>

#include "columns.h"
#include "effect_case.h"
#include "particles/contact_effects.h"

namespace similitude::test {
namespace {

constexpr double k_stiffness = 1e3;   // [N/m], of EffectCase's contact

/// A ball that lies on the floor as deep as its weight presses it, and rolls along x.
std::unique_ptr<SmallBed> rolling(const std::string& effects, double speed) {
  EffectCase ball{.effects = effects, .dt = 4e-6, .sub_steps = 25};
  const double radius = ball.diameter / 2, sunk = ball.mass() * 9.81 / k_stiffness;
  return ball.with({{.place = {0.005, 0.02, radius - sunk}, .velocity = {speed, 0, 0}, .spin = {0, speed / (radius - sunk), 0}}});
}

// A torque mu_r R m g against the rolling, and friction that keeps it rolling: 7/5 m R^2 dw/dt = -mu_r R m g.
class Rolls : public testing::TestWithParam<const char*> {};
TEST_P(Rolls, SlowDownByFiveSeventhsOfTheCoefficientTimesG) {
  const auto bed = rolling(std::string("[{id: rolling_friction, coefficient: 0.01, model: ") + GetParam() + "}]", 0.1);
  run_until(*bed, 0.005);   // epsd has wound its spring, whose dashpot takes 0.1 % of the speed meanwhile
  const double before = bed->simulation->time(), fast = bed->simulation->particles().velocity[0].x;
  run_until(*bed, 0.05);
  const double lost = 5.0 / 7 * 0.01 * 9.81 * (bed->simulation->time() - before);
  EXPECT_NEAR(fast - bed->simulation->particles().velocity[0].x, lost, 1e-4 * lost);   // the lever is R less 2.6e-5 of it
}
TEST_P(Rolls, ComeToRestAndStayThere) {
  const auto bed = rolling(std::string("[{id: rolling_friction, coefficient: 0.01, model: ") + GetParam() + "}]", 0.001);
  run_until(*bed, 0.15);   // gone after 14 ms; epsd's spring swings at 350 rad/s with damping 0.3: e^-14 is left
  EXPECT_LT(std::abs(bed->simulation->particles().velocity[0].x), 1e-5 * 0.001);
  EXPECT_LT(std::abs(bed->simulation->particles().angular_velocity[0].y), 1e-5 * 0.001 / 0.5e-3);
}
INSTANTIATE_TEST_SUITE_P(BothModels, Rolls, testing::Values("constant_torque", "epsd"));

TEST(RollingFriction, LeavesABallThatRollsFreelyAlone) {
  const auto bed = rolling("[]", 0.1);
  run_until(*bed, 0.02);
  EXPECT_NEAR(bed->simulation->particles().velocity[0].x, 0.1, 1e-6 * 0.1);
}

// A ball pressed into a corner that spins along both walls: 2/5 m R^2 dw/dt = -2 mu_r R m g, then rest. If each contact might stop
// the spin alone, two would turn it round, w' = w - 2 w, for ever.
TEST(RollingFriction, SeveralContactsTogetherNeverTurnASpinRound) {
  EffectCase corner{.gravity = "[-9.81 m/s^2, -9.81 m/s^2, 0 m/s^2]",
                    .contact = "{id: linear_spring, stiffness: 1000 N/m, restitution: 0.5, friction: 0}",
                    .effects = "[{id: rolling_friction, coefficient: 0.01}]"};
  const double radius = corner.diameter / 2, place = radius - corner.mass() * 9.81 / k_stiffness;
  const double braking = 2 * 0.01 * 9.81 / (0.4 * radius);   // [rad/s^2]
  const double spin = 50.5 * braking * corner.dt;            // gone after some fifty steps
  const auto bed = corner.with({{.place = {place, place, 0.02}, .spin = {0, 0, spin}}});
  const auto turns = [&] { return bed->simulation->particles().angular_velocity[0].z; };
  for (int step = 0; step < 20; ++step) bed->simulation->step();
  EXPECT_NEAR(turns(), spin - 20 * braking * corner.dt, 1e-4 * spin);   // the lever is R less 1.3e-5 of it
  for (int step = 20; step < 500; ++step) {
    bed->simulation->step();
    ASSERT_GE(turns(), 0) << step;
  }
  EXPECT_LT(turns(), 1e-9 * spin);
}

// The price of a couple without memory: on a slope that the coefficient could hold, the couple that stops within twelve steps is a
// dashpot, and the ball creeps at 12 g sin(a) dt / (2/5).
TEST(RollingFriction, WithoutMemoryABallCreepsDownASlope) {
  const double slope = 0.05;
  EffectCase tilted{.gravity = fmt::format("[{} m/s^2, 0 m/s^2, {} m/s^2]", 9.81 * std::sin(slope), -9.81 * std::cos(slope)),
                    .effects = "[{id: rolling_friction, coefficient: 0.1}]", .dt = 4e-6, .sub_steps = 25};
  const double radius = tilted.diameter / 2, sunk = tilted.mass() * 9.81 * std::cos(slope) / k_stiffness;
  const auto bed = tilted.with({{.place = {0.005, 0.02, radius - sunk}}});
  run_until(*bed, 0.05);
  const double creep = 30 * 9.81 * std::sin(slope) * tilted.dt;
  EXPECT_NEAR(bed->simulation->particles().velocity[0].x, creep, 1e-3 * creep);
}

/// [-], rotational energy over m g d of a bed that has lain for a while, of half of its spheres. Not of all: one contact, or
/// two opposite ones, let a sphere twist freely about the normal.
double rotation_at_rest(const std::string& effects) {
  const auto bed = small_bed(R"(
similitude: 1
title: heap
scene:
  domain:    {size: [5 mm, 5 mm, 12 mm], cell: 1 mm}
  gas:       {density: 1.2 kg/m^3, viscosity: 1.8e-5 Pa s}
  particles: {ball: {diameter: 1 mm, density: 2500 kg/m^3, count: 100}}
  bed:       {fill: lattice}
models: {drag: schiller_naumann, fluid: prescribed, scaling: exact,
         contact: {id: linear_spring, stiffness: 100 N/m, restitution: 0.5, friction: 0.5}, effects: )" + effects + R"(}
time: {end: 1 s, dt: auto}
)");
  run_until(*bed, 0.2);
  const ParticleStore& balls = bed->simulation->particles();
  std::vector<double> energy;
  for (std::size_t i = 0; i < balls.size(); ++i) {
    const Row& spin = balls.angular_velocity[i];   // and the moment of inertia
    energy.push_back(spin.w / 2 * (spin.x * spin.x + spin.y * spin.y + spin.z * spin.z));
  }
  const auto middle = energy.begin() + static_cast<std::ptrdiff_t>(energy.size() / 2);
  std::nth_element(energy.begin(), middle, energy.end());
  return *middle / (balls.velocity[0].w * 9.81 * 1e-3);
}

// The friction of the contact law alone brings this bed to rest; resistance against rolling must not keep it awake. A limit that
// leaves the other contacts no room keeps 2e-7.
TEST(RollingFriction, ABedComesToRestWithItAsWithout) {
  for (const char* effects : {"[]", "[{id: rolling_friction, coefficient: 0.2}]", "[{id: rolling_friction, coefficient: 0.2, model: epsd}]"}) {
    EXPECT_LT(rotation_at_rest(effects), 1e-9) << effects;
  }
}

/// What cohesion adds along the normal, of two spheres of radius R1 and R2, per overlap.
class Pulled {
 public:
  explicit Pulled(EffectModel model, double radius = 1e-3) : model_(std::move(model)), remembers_(needs_of(model_).history_count > 0) {
    for (std::size_t row = 0; row < 8; ++row) {
      columns_.normal.set(row, {1, 0, 0});
      columns_.radius_i[row] = columns_.radius_j[row] = radius;
      columns_.effective_mass[row] = 1e-6;
    }
  }
  double force(double overlap) {
    similitude_contact_effect_block b{};
    b.struct_size = sizeof b;
    b.rows = 8;
    b.dt = 1e-6;
    for (std::size_t a = 0; a < 3; ++a) {
      b.normal[a] = columns_.normal.axis[a].data();
      b.velocity[a] = columns_.velocity.axis[a].data();
      b.law_force[a] = columns_.couple.axis[a].data();
      b.force[a] = columns_.force.axis[a].data();
    }
    for (std::size_t row = 0; row < 8; ++row) {
      columns_.overlap[row] = overlap;
      columns_.force.set(row, {0, 0, 0});
    }
    b.overlap = columns_.overlap.data();
    b.radius_i = columns_.radius_i.data();
    b.radius_j = columns_.radius_j.data();
    b.effective_mass = columns_.effective_mass.data();
    b.history[0] = remembers_ ? columns_.history[0].data() : nullptr;
    similitude_status status{};
    model_.functions().contacts(model_.instance(), &b, &status);
    EXPECT_EQ(status.code, 0) << status.text;
    return columns_.force.get(3).x;
  }

 private:
  EffectModel model_;
  bool remembers_;
  ContactColumns columns_{8};
};

constexpr double k_energy = 0.05, k_youngs = 1e7, k_poisson = 0.25;   // [J/m^2], [Pa], [-]
const double k_modulus = k_youngs / (2 * (1 - k_poisson * k_poisson));   // [Pa], E*
constexpr double k_radius = 0.5e-3;                                    // [m], R* of two spheres of 1 mm radius

Pulled jkr() {
  return Pulled(effect_model("cohesion", {{"surface_energy", k_energy}, {"youngs_modulus", k_youngs}, {"poisson_ratio", k_poisson}},
                             {{"model", "jkr"}}));
}
double hertz(double overlap) { return overlap > 0 ? 4.0 / 3 * k_modulus * std::sqrt(k_radius * overlap) * overlap : 0; }

// Johnson, Kendall & Roberts (1971): whatever the stiffness, 3/2 pi w R* pulls two spheres apart.
TEST(Cohesion, JkrHoldsThreeHalvesOfPiTimesEnergyTimesRadius) {
  Pulled contact = jkr();
  const double unit = std::pow(4.5 * k_pi * k_energy * k_radius * k_radius / k_modulus, 2.0 / 3) / k_radius;
  contact.force(1e-3 * unit);   // they have touched
  double least = 0;
  for (double overlap = 0.2; overlap > -0.275; overlap -= 1e-4) least = std::min(least, contact.force(overlap * unit) + hertz(overlap * unit));
  EXPECT_NEAR(least, -1.5 * k_pi * k_energy * k_radius, 1e-6 * -least);   // the scan steps over the least by 1e-4 of the overlap
}

// The parameter form: F = 4 E* a^3 / (3 R*) - sqrt(8 pi w E* a^3) at delta = a^2/R* - sqrt(2 pi w a / E*).
TEST(Cohesion, JkrMeetsTheParameterFormFromTheTearToDeepOverlap) {
  Pulled contact = jkr();
  const double unloaded = std::cbrt(4.5 * k_pi * k_energy * k_radius * k_radius / k_modulus);
  contact.force(1e-9);
  for (double a = 0.31; a < 30; a *= 1.3) {
    const double radius = a * unloaded;
    const double overlap = radius * radius / k_radius - std::sqrt(2 * k_pi * k_energy * radius / k_modulus);
    const double cube = radius * radius * radius;
    const double force = 4 * k_modulus * cube / (3 * k_radius) - std::sqrt(8 * k_pi * k_energy * k_modulus * cube);
    const double scale = 4 * k_modulus * cube / (3 * k_radius) + 1.5 * k_pi * k_energy * k_radius;
    EXPECT_NEAR(contact.force(overlap) + hertz(overlap), force, 1e-9 * scale) << a;
  }
}

TEST(Cohesion, JkrPullsBelowTouchOnlyWhatHasTouched) {
  Pulled contact = jkr();
  const double unit = std::pow(4.5 * k_pi * k_energy * k_radius * k_radius / k_modulus, 2.0 / 3) / k_radius;
  EXPECT_EQ(contact.force(-0.1 * unit), 0);
  EXPECT_LT(contact.force(0.1 * unit), 0);
  EXPECT_LT(contact.force(-0.1 * unit), 0);
  EXPECT_EQ(contact.force(-0.2752 * unit), 0);   // torn
  EXPECT_EQ(contact.force(-0.1 * unit), 0);
}

// Smooth spheres: Hamaker's A R* / (6 s^2), 1937; rough ones by Rumpf (1970).
TEST(Cohesion, VanDerWaalsOfSmoothSpheresIsHamakers) {
  Pulled smooth(effect_model("cohesion", {{"asperity", 0}}));
  const double touch = 6.5e-20 * k_radius / (6 * 16e-20);
  EXPECT_NEAR(smooth.force(0), -touch, 1e-12 * touch);
  EXPECT_NEAR(smooth.force(1e-6), -touch, 1e-12 * touch);
  EXPECT_NEAR(smooth.force(-4e-10), -touch / 4, 1e-12 * touch);
}

/// A ball pressed gently against the floor while "gravity" pulls it off by `share` of JKR's pull-off.
double height_after_pulling(double share) {
  EffectCase ball{.diameter = 1e-3, .density = 2500,
                  .contact = "{id: hertz_mindlin, youngs_modulus: 10 MPa, poisson_ratio: 0.25, restitution: 0.3, friction: 0.3}",
                  .effects = "[{id: cohesion, model: jkr, surface_energy: 0.05 J/m^2}]", .dt = 1e-6, .sub_steps = 50};
  const double pull_off = 1.5 * k_pi * k_energy * ball.diameter / 2;   // R* of a sphere on a wall
  ball.gravity = fmt::format("[0 m/s^2, 0 m/s^2, {} m/s^2]", share * pull_off / ball.mass());
  const double unit = std::pow(4.5 * k_pi * k_energy * 0.25e-6 / k_modulus, 2.0 / 3) / 0.5e-3;
  const auto bed = ball.with({{.place = {0.02, 0.02, 0.5e-3 - unit / 3}}});   // where JKR's force is zero
  run_until(*bed, 3e-3);
  return bed->simulation->particles().position[0].z - 0.5e-3;
}

// Lists, reach and history at work: the ball hangs below touch by attraction alone, or is torn off. A load that comes at once swings
// to twice its elongation, hence half the pull-off.
TEST(Cohesion, HoldsABallAgainstHalfThePullOffAndLetsGoAboveIt) {
  const double unit = std::pow(4.5 * k_pi * k_energy * 0.25e-6 / k_modulus, 2.0 / 3) / 0.5e-3;
  EXPECT_LT(height_after_pulling(0.5), 0.2752 * unit);
  EXPECT_GT(height_after_pulling(1.05), 10 * unit);
}

// Beyond the reach of the law nothing of it is left: no force, and friction starts anew.
TEST(Cohesion, TheLawIsNotAskedBeyondItsReach) {
  EffectCase pair{.gravity = "0 m/s^2", .effects = "[{id: cohesion, hamaker: 0 J, separation: 100 nm, asperity: 0 m}]"};
  const auto bed = pair.with({{.place = {0.02, 0.02, 0.02}, .velocity = {0, 0.01, 0}}, {.place = {0.02 + 1e-3 + 3e-7, 0.02, 0.02}}});
  run_until(*bed, 1e-4);
  EXPECT_EQ(bed->simulation->engine().report().contacts, 1u);
  EXPECT_EQ(bed->simulation->particles().force[0].x, 0);
  EXPECT_EQ(bed->simulation->particles().force[0].y, 0);
}

}  // namespace
}  // namespace similitude::test
