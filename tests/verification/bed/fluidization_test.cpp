#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

#include <fmt/format.h>

#include "ramp_bed.h"
#include "record.h"

namespace similitude::test {
namespace {

/// The drag law's own u_mf [m/s]: (beta/phi) phi U / eps^2 = phi (rho_p - rho_f) g, by bisection.
double minimum_fluidization_velocity(const DragModel& drag, double gas_fraction) {
  double low = 0, high = 5;
  for (int i = 0; i < 100; ++i) {
    const double middle = (low + high) / 2;
    const double carried = exchange_per_volume(drag, gas_fraction, middle / gas_fraction) * middle / (gas_fraction * gas_fraction);
    (carried < (k_density - k_gas_density) * k_gravity ? low : high) = middle;
  }
  return (low + high) / 2;
}

}  // namespace

class SlowRamp : public testing::TestWithParam<RampCase> {};

TEST_P(SlowRamp, FindsTheDragLawsMinimumFluidizationVelocityAndCarriesTheBed) {
  const RampCase& ramp = GetParam();
  const auto bed = small_bed(bed_case(ramp));
  ASSERT_GE(bed->filled.height, 40 * k_diameter);
  const double weight = ramp.weight();

  // Fixed bed: dp = a U + b U^2 by least squares over the lower part of the ramp, where nothing moves yet.
  double uu = 0, uuu = 0, uuuu = 0, pu = 0, puu = 0;
  double gas_fraction_sum = 0;
  int fixed_samples = 0;
  double plateau = 0;
  int plateau_samples = 0;
  while (bed->simulation->time() < ramp.ramp) {
    bed->simulation->step();
    const double velocity = ramp.velocity(bed->simulation->time());
    const double drop = pressure_drop(*bed);
    if (drop > 0.1 * weight && drop < 0.7 * weight && plateau_samples == 0) {
      const double u = velocity;
      uu += u * u;
      uuu += u * u * u;
      uuuu += u * u * u * u;
      pu += drop * u;
      puu += drop * u * u;
      gas_fraction_sum += mean_gas_fraction(*bed, bed->filled.height);
      ++fixed_samples;
    }
    if (velocity > 0.42) {
      plateau += drop;
      ++plateau_samples;
    }
  }
  ASSERT_GT(fixed_samples, 100);
  ASSERT_GT(plateau_samples, 100);
  plateau /= plateau_samples;
  EXPECT_NEAR(plateau, weight, 0.02 * weight);

  const double determinant = uu * uuuu - uuu * uuu;
  const double a = (pu * uuuu - puu * uuu) / determinant, b = (puu * uu - pu * uuu) / determinant;
  const double crossing = (-a + std::sqrt(a * a + 4 * b * plateau)) / (2 * b);
  const double gas_fraction = gas_fraction_sum / fixed_samples;
  const double expected = minimum_fluidization_velocity(bed->assembly->drag, gas_fraction);
  EXPECT_NEAR(crossing, expected, 0.05 * expected);
  RecordProperty("u_mf", fmt::format("{:.4f}", crossing));
  record({"minimum fluidisation of a settled bed", "the drag law's own at the bed's gas fraction",
          percent(std::abs(crossing / expected - 1)), ""});
  std::printf("  %s in %s: u_mf %.4f m/s at eps %.4f; the law's own %.4f; plateau %.1f Pa of %.1f Pa\n", ramp.drag.c_str(),
              ramp.fluid.c_str(), crossing, gas_fraction,
              expected, plateau, weight);
}

INSTANTIATE_TEST_SUITE_P(DragLaws, SlowRamp, testing::Values(RampCase{"syamlal_obrien", "vans"}, RampCase{"gidaspow", "vans"}, RampCase{"gidaspow", "porous"}),
                         [](const auto& info) { return fmt::format("{}_{}", info.param.drag, info.param.fluid); });

}  // namespace similitude::test
