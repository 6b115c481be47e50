// The smallest and the oddest of beds.
#include "hard_case.h"

namespace similitude::test {
namespace {

constexpr Grain k_grain;

HardCase one_class() {
  HardCase c;
  c.bed = "fill: none";
  c.particles = "grain: {diameter: 1 mm, density: 1040 kg/m^3}";
  return c;
}

}  // namespace

TEST(ZeroParticles, LeaveTheGasAlone) {
  HardCase c;
  c.bed = "fill: none";
  c.particles = "";
  c.patches = "inlet: {face: bottom, velocity: 1 m/s}, outlet: {face: top, pressure: 0 Pa}";
  const auto bed = small_bed(text_of(c));
  Watch watch(*bed);
  watch.at_least(0.1);
  watch.expect_sound(0.01);
  EXPECT_EQ(bed->simulation->particles().size(), 0u);
}

TEST(OneParticle, FallsBouncesAndComesToRest) {
  HardCase c = one_class();
  ParticleStore particles = empty_store();
  k_grain.add(particles, {5e-3, 5e-3, 10e-3});
  const auto bed = small_bed(text_of(c), &particles);
  Watch watch(*bed);
  watch.until(0.6);
  watch.expect_sound(0.05);
  EXPECT_LT(bed->simulation->engine().report().largest_speed, 1e-6);   // [m/s]
}

TEST(OneCell, InDepthIsABedOfTwoDimensions) {
  HardCase c;
  c.size = "[20 mm, 3 mm, 50 mm]";
  c.cell = "[2.5 mm, 3 mm, 2.5 mm]";
  c.patches = "spout: {face: bottom, x: [7.5 mm, 12.5 mm], velocity: 4 m/s}, outlet: {face: top, pressure: 0 Pa}";
  for (const char* scene : {"", "  periodic: [y]"}) {
    c.scene = scene;
    const auto bed = small_bed(text_of(c));
    Watch watch(*bed);
    watch.at_least(0.05);
    watch.expect_sound(0.10);
  }
}

TEST(OneCell, IsABoxOfGas) {
  HardCase c = one_class();
  c.size = "[10 mm, 10 mm, 10 mm]";
  c.cell = "10 mm";
  c.patches = "";
  ParticleStore particles = empty_store();
  k_grain.add(particles, {5e-3, 5e-3, 5e-3});
  const auto bed = small_bed(text_of(c), &particles);
  Watch watch(*bed);
  watch.at_least(0.05);
  watch.expect_sound(0.05);
}

// A gas so thin that it is not there: a billionth of air's density and viscosity.
TEST(Vacuum, LetsABedFallAsIfThereWereNothing) {
  HardCase c = one_class();
  c.gas = "density: 1e-9 kg/m^3, viscosity: 1e-14 Pa s";
  ParticleStore particles = empty_store();
  k_grain.add(particles, {5e-3, 5e-3, 35e-3});
  const auto bed = small_bed(text_of(c), &particles);
  Watch watch(*bed);
  watch.until(0.07);
  const double time = bed->simulation->time();
  EXPECT_NEAR(bed->simulation->particles().velocity[0].z, -9.81 * time, 1e-6 * 9.81 * time);
  watch.expect_sound(0.05);
}

// In a gap of 0.95 diameters beside a plate, on its edge, and in a corner of the box.
TEST(Wedged, BetweenPlateAndWallAParticleIsHeldAndKeepsStill) {
  HardCase c = one_class();
  c.size = "[10 mm, 10 mm, 40 mm]";
  c.scene = "  baffles: {plate: {at_x: 2.5 mm, z: [10 mm, 20 mm], thickness: 3.1 mm}}";   // its face is 0.95 mm from the wall
  ParticleStore particles = empty_store();
  k_grain.add(particles, {0.475e-3, 5e-3, 15e-3});   // between plate and wall
  k_grain.add(particles, {0.5e-3, 3e-3, 22e-3});   // above the gap's mouth, which is as round as the plate's edge
  k_grain.add(particles, {2.5e-3, 7e-3, 22.0e-3});   // above the edge: falls to one side
  k_grain.add(particles, {9.5e-3, 9.5e-3, 0.5e-3});   // in a corner
  const auto bed = small_bed(text_of(c), &particles);
  Watch watch(*bed);
  watch.at_least(0.3);
  watch.expect_sound(0.10);
  const ParticleStore& now = bed->simulation->particles();
  for (std::size_t row = 0; row < now.size(); ++row) {
    if (now.id[row] == 2) continue;   // may have fallen to the floor, where nothing stops a sphere that rolls
    const Row& v = now.velocity[row];
    EXPECT_LT(std::hypot(v.x, v.y, v.z), 1e-3) << "particle " << now.id[row];   // [m/s]
  }
}

// Ten times the diameter, a thousand times the mass: the small ones must not be shot through the large ones.
TEST(Sizes, OneToTenAndMassesOneToAThousandShareABed) {
  HardCase c;
  c.size = "[20 mm, 20 mm, 60 mm]";
  c.cell = "5 mm";
  c.particles = "fine: {diameter: 0.8 mm, density: 2500 kg/m^3, count: 1500}, coarse: {diameter: 8 mm, density: 2500 kg/m^3, count: 5}";
  c.contact = "{id: linear_spring, stiffness: 500 N/m, restitution: 0.9, friction: 0.3}";
  c.patches = "inlet: {face: bottom, velocity: 0.8 m/s}, outlet: {face: top, pressure: 0 Pa}";
  const auto bed = small_bed(text_of(c));
  Watch watch(*bed);
  watch.at_least(0.05);
  watch.expect_sound(0.30);
}

// Spheres pressed into each other by a tenth of a diameter everywhere, a solids fraction of 0.70: the energy in their springs
// is all they may come out with.
TEST(OverPacked, ComesApartWithNoMoreThanItsSpringsHold) {
  HardCase c = one_class();
  c.smoothing = "3 mm";
  ParticleStore particles = empty_store();
  const double pitch = 0.905e-3, stiffness = 200;
  int count = 0, contacts = 0;
  for (int k = 0; k < 11; ++k) {
    for (int j = 0; j < 11; ++j) {
      for (int i = 0; i < 11; ++i, ++count) {
        k_grain.add(particles, {pitch * (i + 0.5), pitch * (j + 0.5), pitch * (k + 0.5)});
        contacts += (i > 0) + (j > 0) + (k > 0);
      }
    }
  }
  const double overlap = 1e-3 - pitch;
  // Wall contacts: three sides at half a pitch from the lowest centres.
  const double wall = 0.5e-3 - pitch / 2;
  const double springs = 0.5 * stiffness * (contacts * overlap * overlap + 3 * 121 * wall * wall);
  const auto bed = small_bed(text_of(c), &particles);
  const double before = mechanical_energy(*bed->simulation);
  Watch watch(*bed);
  EXPECT_LT(*std::ranges::min_element(bed->simulation->exchange().gas_fraction), 0.36);
  double most = 0;
  while (bed->simulation->time() < 0.05 * Watch::longer()) {
    watch.step();
    most = std::max(most, mechanical_energy(*bed->simulation) - before);
  }
  std::printf("  springs held %.3g J, came out with at most %.3g J\n", springs, most);
  EXPECT_LT(most, springs);
  watch.expect_sound(2 * overlap / 1e-3);   // a wave from the free sides meets its own echo at the walls: twice at most
}

}  // namespace similitude::test
