// A bed a quarter the size of another, exactly similar to it: every ratio is a power of two, which changes exponents only, so
// that the two runs must agree to the last bit of every position and velocity. Any constant with a unit that hides in
// the framework, in a plugin or in a file shows here.
#include <gtest/gtest.h>

#include <cmath>
#include <ostream>

#include <fmt/format.h>

#include "../bed/small_bed.h"
#include "../record.h"

namespace similitude::test {
namespace {

constexpr int k_gas_steps = 2000;

std::string bed_case(const std::string& contact, const std::string& scaling) {
  return fmt::format(R"(
similitude: 1
title: a spouting bed between draft plates
scene:
  domain:    {{size: [40 mm, 20 mm, 60 mm], cell: 5 mm}}
  gas:       {{density: 1.225 kg/m^3, viscosity: 1.79e-5 Pa s}}
  particles: {{alumina: {{diameter: 2 mm, density: 1040 kg/m^3, count: 2000}}}}
  bed:       {{fill: settle, cache: false}}
  patches:
    spout:      {{face: bottom, x: [15 mm, 25 mm], velocity: 9.3 m/s, ramp: 10 ms}}
    background: {{face: bottom, rest: true, velocity: 0.7 m/s}}
    outlet:     {{face: top, pressure: 0 Pa}}
  baffles:   {{plates: {{at_x: [10 mm, 30 mm], z: [10 mm, 40 mm], thickness: 1.7 mm}}}}
models:
  drag: syamlal_obrien
  contact: {}
  fluid: vans
  scaling: {}
time: {{end: 1 s, dt: auto}}
)",
                     contact, scaling);
}

struct Case {
  const char* name;
  const char* contact;
  const char* scaling;
};

std::ostream& operator<<(std::ostream& out, const Case& one) { return out << one.name; }

/// Divided by a power of two the small bed's values are the real one's.
testing::AssertionResult same_bits(const Column<Row>& real, const Column<Row>& small, double ratio, const char* what) {
  for (std::size_t row = 0; row < real.size(); ++row) {
    const Row back{small[row].x / ratio, small[row].y / ratio, small[row].z / ratio, 0};
    if (back.x == real[row].x && back.y == real[row].y && back.z == real[row].z) continue;
    return testing::AssertionFailure() << fmt::format("{} of particle {}: ({:a}, {:a}, {:a}) against ({:a}, {:a}, {:a})", what, row,
                                                      back.x, back.y, back.z, real[row].x, real[row].y, real[row].z);
  }
  return testing::AssertionSuccess();
}

testing::AssertionResult same_bits(const Column<double>& real, const Column<double>& small, double ratio, const char* what) {
  for (std::size_t i = 0; i < real.size(); ++i)
    if (small[i] / ratio != real[i])
      return testing::AssertionFailure() << fmt::format("{} of cell {}: {:a} against {:a}", what, i, small[i] / ratio, real[i]);
  return testing::AssertionSuccess();
}

testing::AssertionResult same_state(const Simulation& real, const Simulation& small) {
  const ParticleStore &a = real.particles(), &b = small.particles();
  if (a.size() != b.size()) return testing::AssertionFailure() << a.size() << " particles against " << b.size();
  for (std::size_t row = 0; row < a.size(); ++row)
    if (a.id[row] != b.id[row]) return testing::AssertionFailure() << "another order of particles";
  testing::AssertionResult all = same_bits(a.position, b.position, 0.25, "position");
  if (all) all = same_bits(a.velocity, b.velocity, 0.5, "velocity");
  if (all) all = same_bits(real.gas().velocity, small.gas().velocity, 0.5, "gas velocity");
  if (all) all = same_bits(real.gas().pressure, small.gas().pressure, 0.25, "pressure");
  if (all) all = same_bits(real.exchange().gas_fraction, small.exchange().gas_fraction, 1, "gas fraction");
  return all;
}

}  // namespace

class ExactQuarterOf : public testing::TestWithParam<Case> {};

TEST_P(ExactQuarterOf, RepeatsTheRealBedToTheLastBit) {
  const Case& one = GetParam();
  const auto real = small_bed(bed_case(one.contact, "exact"));
  const auto small = small_bed(bed_case(one.contact, one.scaling));
  ASSERT_EQ(real->steps.dt, 2 * small->steps.dt);
  ASSERT_EQ(real->steps.sub_steps, small->steps.sub_steps);
  ASSERT_TRUE(same_state(*real->simulation, *small->simulation)) << "at the start";
  for (int step = 1; step <= k_gas_steps; ++step) {
    real->simulation->step();
    small->simulation->step();
    if (step % 100 != 0 && step > 10) continue;
    ASSERT_TRUE(same_state(*real->simulation, *small->simulation)) << "after step " << step;
  }
  record({fmt::format("the bed at a quarter of its size, {}", one.name), "the real bed, every bit", "none", ""});
  // The bed did move: bits that agree at rest would say little.
  double fastest = 0;
  for (const Row& v : real->simulation->particles().velocity) fastest = std::max(fastest, std::abs(v.z));
  EXPECT_GT(fastest, 0.1);
}

// The comparison sees the last bit: a viscosity off by one of them is found at once.
TEST(ExactQuarter, WouldShowAViscosityThatIsOffByItsLastBit) {
  const std::string contact = "{id: linear_spring, stiffness: 300 N/m, restitution: 0.74, friction: 0.2}";
  const auto real = small_bed(bed_case(contact, "exact"));
  const auto small = small_bed(bed_case(contact, "{id: custom, length: 0.25, diameter: 0.25, gas_viscosity: 0.12500000000000003}"));
  ASSERT_TRUE(same_state(*real->simulation, *small->simulation));
  for (int step = 0; step < 10; ++step) {
    real->simulation->step();
    small->simulation->step();
  }
  EXPECT_FALSE(same_state(*real->simulation, *small->simulation));
}

INSTANTIATE_TEST_SUITE_P(
    Laws, ExactQuarterOf,
    testing::Values(Case{"linear_spring_by_similarity", "{id: linear_spring, stiffness: 300 N/m, restitution: 0.74, friction: 0.2}",
                         "{id: similarity, geometry: 0.25, n: 0.25}"},
                    Case{"fluent_dem_by_glicksman_full", "{id: fluent_dem, stiffness: 300 N/m, restitution: 0.74, v_glide: 0.7 m/s}",
                         "{id: glicksman_full, geometry: 0.25, gas_density: 1}"}),
    [](const auto& info) { return std::string(info.param.name); });

}  // namespace similitude::test
