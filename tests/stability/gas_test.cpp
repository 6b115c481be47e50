// Gas and grains at the edge: stiff drag, heavy gas, jets at once, coarse and fine cells, closed boxes, lifted beds.
#include "hard_case.h"
#include "scene/messages.h"

namespace similitude::test {

// The gas takes the particles' velocity in eps rho_f/beta = 6e-7 s, a hundredth of the gas step: explicit drag diverges at once.
TEST(StiffDrag, OfFiftyMicrometreParticlesIsCarriedByASettlingBed) {
  HardCase c;
  c.size = "[0.6 mm, 0.6 mm, 3 mm]";
  c.cell = "0.15 mm";
  c.particles = "fines: {diameter: 50 um, density: 1500 kg/m^3, count: 2500}";
  c.contact = "{id: linear_spring, stiffness: 1 N/m, restitution: 0.8, friction: 0.3}";
  c.patches = "inlet: {face: bottom, velocity: 2 mm/s, ramp: 0 s}, outlet: {face: top, pressure: 0 Pa}";
  c.scene = "  periodic: [x, y]";
  c.time = "gas_dt: 8e-5 s";
  const auto bed = small_bed(text_of(c));
  Watch watch(*bed);
  watch.steps(80 * Watch::longer());
  double largest = 0;   // [-], gas step over the gas's drag time
  const ExchangeFields& fields = bed->simulation->exchange();
  for (std::size_t cell = 0; cell < fields.exchange.size(); ++cell) {
    largest = std::max(largest, bed->steps.gas_dt() * fields.exchange[cell] / (fields.gas_fraction[cell] * 1.225));
  }
  EXPECT_GT(largest, 100);
  watch.expect_sound(0.05);
  EXPECT_LT(watch.gas_speed, 0.02);   // [m/s], ten times what is blown in: interstitial velocity and a loose top
  EXPECT_LT(watch.fastest, 0.02);
}

// A fluid resists being pushed aside. Where it weighs more than the particles, its resistance, known one gas step late, would
// throw them back farther than they came: foam in water leaves its box within a few steps. Such a bed is refused in words.
TEST(LightParticles, ThanTheGasAreRefused) {
  HardCase c;
  c.gas = "density: 1000 kg/m^3, viscosity: 1e-3 Pa s";
  c.particles = "foam: {diameter: 1 mm, density: 50 kg/m^3, count: 300}";
  c.bed = "fill: lattice";
  c.effects = "[]";
  try {
    small_bed(text_of(c));
    FAIL() << "was accepted";
  } catch (const InputError& refused) {
    const std::string text = refused.what();
    EXPECT_EQ(text.substr(text.find(".yaml:")),
              ".yaml:14:10: models.fluid: the simulated particles foam, of 50 kg/m^3, are lighter than the gas of 1000 kg/m^3: its "
              "resistance to being pushed aside, known one gas step late, would throw them about.\n"
              "  Give the particles the inertia of the gas around them, models.effects: [virtual_mass], or use fluid: prescribed, which "
              "feels nothing of them.");
  }
}

// With the inertia of the liquid around it the foam rises.
TEST(LightParticles, WithVirtualMassRise) {
  HardCase c;
  c.gas = "density: 1000 kg/m^3, viscosity: 1e-3 Pa s";
  c.particles = "foam: {diameter: 1 mm, density: 50 kg/m^3, count: 300}";
  c.contact = "{id: linear_spring, stiffness: 50 N/m, restitution: 0.8, friction: 0.3}";
  c.bed = "fill: lattice";
  c.patches = "";
  c.effects = "[virtual_mass]";
  const auto bed = small_bed(text_of(c));
  const double before = mean_height(bed->simulation->particles());
  Watch watch(*bed);
  watch.at_least(0.1);
  std::printf("  fastest %.3f m/s, overlap %.3g\n", watch.fastest, watch.overlap);
  EXPECT_GT(mean_height(bed->simulation->particles()), before);
  watch.expect_sound(0.05);
  EXPECT_LT(watch.fastest, 0.3);   // [m/s], twice the velocity of one alone, 0.13 m/s
}

// Nearly as heavy as the liquid, and packed: the bed that comes closest to what is refused.
TEST(LightParticles, OfPolystyreneSettleInWater) {
  HardCase c;
  c.gas = "density: 1000 kg/m^3, viscosity: 1e-3 Pa s";
  c.particles = "polystyrene: {diameter: 1 mm, density: 1050 kg/m^3, count: 1200}";
  c.contact = "{id: linear_spring, stiffness: 50 N/m, restitution: 0.8, friction: 0.3}";
  c.bed = "fill: lattice";
  const auto bed = small_bed(text_of(c));
  Watch watch(*bed);
  watch.at_least(0.1);
  watch.expect_sound(0.05);
  EXPECT_LT(watch.fastest, 0.02);   // [m/s], of one sphere alone
}

TEST(HeavyLiquid, SettlesGlassBeads) {
  HardCase c;
  c.gas = "density: 1000 kg/m^3, viscosity: 1e-3 Pa s";
  c.particles = "glass: {diameter: 1 mm, density: 2500 kg/m^3, count: 400}";
  c.bed = "fill: lattice";
  c.patches = "";
  const auto bed = small_bed(text_of(c));
  Watch watch(*bed);
  watch.at_least(0.1);
  watch.expect_sound(0.05);
  EXPECT_LT(watch.fastest, 0.16);   // [m/s], of one sphere alone
}

class SpoutAtOnce : public testing::TestWithParam<double> {};

TEST_P(SpoutAtOnce, OpensASettledBed) {
  HardCase c;
  c.size = "[30 mm, 5 mm, 80 mm]";
  c.particles = "grain: {diameter: 1 mm, density: 1040 kg/m^3, count: 2500}";
  c.patches = fmt::format("spout: {{face: bottom, x: [12.5 mm, 17.5 mm], velocity: {} m/s, ramp: 0 s}}, "
                          "outlet: {{face: top, pressure: 0 Pa}}", GetParam());
  c.contact = "{id: linear_spring, stiffness: 500 N/m, restitution: 0.74, friction: 0.2}";
  const auto bed = small_bed(text_of(c));
  Watch watch(*bed);
  watch.at_least(GetParam() > 30 ? 0.003 : 0.01);
  watch.expect_sound(0.30);
  EXPECT_LT(watch.fastest, GetParam());
  std::printf("  overlap %.3f, CFL %.2f, eps >= %.3f, fastest %.2f m/s, gas %.1f m/s\n", watch.overlap, watch.courant,
              watch.smallest_gas_fraction, watch.fastest, watch.gas_speed);
}

INSTANTIATE_TEST_SUITE_P(Jets, SpoutAtOnce, testing::Values(13.2, 60.0),
                         [](const auto& info) { return fmt::format("at_{}_m_s", static_cast<int>(info.param)); });

// Just below the Courant number at which a run is stopped.
TEST(Courant, NearOneIsHeldByAJetAboveABed) {
  HardCase c;
  c.size = "[20 mm, 5 mm, 60 mm]";
  c.particles = "grain: {diameter: 1 mm, density: 1040 kg/m^3, count: 200}";
  c.patches = "jet: {face: bottom, x: [7.5 mm, 12.5 mm], velocity: 10 m/s, ramp: 0 s}, outlet: {face: top, pressure: 0 Pa}";
  c.time = "gas_dt: 0.13 ms";
  const auto bed = small_bed(text_of(c));
  Watch watch(*bed);
  watch.at_least(0.1);
  std::printf("  CFL %.2f, gas %.1f m/s\n", watch.courant, watch.gas_speed);
  EXPECT_GT(watch.courant, 0.7);
  watch.expect_sound(0.30);
  EXPECT_LT(watch.gas_speed, 1.6 * 10);
}

// Particles larger than cells: a raw deposit would fill cells beyond one.
TEST(Cells, OfHalfADiameterSeeASmoothBed) {
  HardCase c;
  c.size = "[6 mm, 6 mm, 24 mm]";
  c.cell = "0.5 mm";
  c.particles = "grain: {diameter: 1 mm, density: 1040 kg/m^3, count: 300}";
  c.patches = "inlet: {face: bottom, velocity: 0.6 m/s}, outlet: {face: top, pressure: 0 Pa}";
  const auto bed = small_bed(text_of(c));
  Watch watch(*bed);
  watch.at_least(0.01);
  watch.expect_sound(0.10);
}

TEST(Cells, OfAspectRatioTenSolveTheGas) {
  HardCase c;
  c.size = "[10 mm, 10 mm, 80 mm]";
  c.cell = "[1 mm, 1 mm, 10 mm]";
  c.patches = "inlet: {face: bottom, velocity: 0.6 m/s}, outlet: {face: top, pressure: 0 Pa}";
  const auto bed = small_bed(text_of(c));
  Watch watch(*bed);
  watch.at_least(0.05);
  watch.expect_sound(0.10);
}

TEST(ClosedBox, LetsABedFallThroughItsGas) {
  HardCase c;
  c.patches = "";
  c.bed = "fill: lattice";
  c.particles = "grain: {diameter: 1 mm, density: 1040 kg/m^3, count: 700}";
  const auto bed = small_bed(text_of(c));
  Watch watch(*bed);
  const double before = mechanical_energy(*bed->simulation);
  watch.at_least(0.1);
  watch.expect_sound(0.10);
  EXPECT_LT(mechanical_energy(*bed->simulation), before);
}

TEST(Slug, OfAWholeBedIsLiftedByThreeTimesItsMinimumVelocity) {
  HardCase c;
  c.size = "[7.5 mm, 7.5 mm, 100 mm]";
  c.particles = "grain: {diameter: 1 mm, density: 1040 kg/m^3, count: 700}";
  c.patches = "inlet: {face: bottom, velocity: 1.1 m/s, ramp: 0 s}, outlet: {face: top, pressure: 0 Pa}";
  const auto bed = small_bed(text_of(c));
  const double before = mean_height(bed->simulation->particles());
  Watch watch(*bed);
  watch.at_least(0.05);
  EXPECT_GT(mean_height(bed->simulation->particles()), 1.1 * before);
  watch.expect_sound(0.10);
}

// Gas blown, shut off, and blown again at once: the bed collapses and is lifted, with the bed as each phase left it.
TEST(Inlet, SwitchedOnOffAndOnAgain) {
  HardCase c;
  c.size = "[7.5 mm, 7.5 mm, 60 mm]";
  c.particles = "grain: {diameter: 1 mm, density: 1040 kg/m^3, count: 500}";
  std::unique_ptr<SmallBed> bed;
  for (const char* velocity : {"1 m/s", "0 m/s", "1 m/s"}) {
    c.patches = fmt::format("inlet: {{face: bottom, velocity: {}, ramp: 0 s}}, outlet: {{face: top, pressure: 0 Pa}}", velocity);
    ParticleStore particles = empty_store();
    if (bed) particles.copy_rows(bed->simulation->particles());
    bed = small_bed(text_of(c), bed ? &particles : nullptr);
    c.bed = "fill: none";
    c.particles = "grain: {diameter: 1 mm, density: 1040 kg/m^3}";
    Watch watch(*bed);
    watch.at_least(0.04);
    watch.expect_sound(0.10);
  }
}

}  // namespace similitude::test
