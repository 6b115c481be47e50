// Contacts at the edge of what they can bear. No gas to speak of: what goes wrong here is the contacts' own.
#include "hard_case.h"

namespace similitude::test {
namespace {

HardCase without_gas() {
  HardCase c;
  c.gas = "density: 1e-12 kg/m^3, viscosity: 1e-15 Pa s";
  c.patches = "";
  c.fluid = "prescribed";
  c.drag = "schiller_naumann";
  return c;
}

std::string seconds(double time) { return fmt::format("{:.17g} s", time); }

const TimeStepLimit& limit_of(const TimeSteps& steps, const std::string& name) {
  return *std::ranges::find(steps.limits, name, &TimeStepLimit::name);
}

void shake(ParticleStore& particles, double speed) {
  std::mt19937_64 random(5);
  for (Row& v : particles.velocity) {
    for (double* component : {&v.x, &v.y, &v.z}) {
      *component = speed * (2 * static_cast<double>(random() >> 11) / 9007199254740992.0 - 1);
    }
  }
}

struct Law {
  const char* name;
  const char* parameters;   // but for restitution
};
constexpr std::array<Law, 5> k_laws{{{"linear_spring", "id: linear_spring, stiffness: 200 N/m, friction: 0.3"},
                                     {"frictionless", "id: linear_spring, stiffness: 200 N/m, friction: 0"},
                                     {"fluent_dem", "id: fluent_dem, stiffness: 200 N/m"},
                                     {"hertz_mindlin", "id: hertz_mindlin, youngs_modulus: 1 MPa, poisson_ratio: 0.25, friction: 0.3"},
                                     {"hertz_thornton", "id: hertz_thornton, youngs_modulus: 1 MPa, poisson_ratio: 0.25, friction: 0.3"}}};

}  // namespace

class AtTheHardTimeStep : public testing::TestWithParam<std::tuple<Law, double>> {};

// A packed bed, where a particle has many partners at once, moved by 5 cm/s and left to itself at the longest step that a case
// may ask for. Unstable springs double their energy in some ten steps; this is some thousand.
TEST_P(AtTheHardTimeStep, APackedBedDoesNotHeat) {
  const auto& [law, restitution] = GetParam();
  HardCase c = without_gas();
  c.size = "[8 mm, 8 mm, 40 mm]";
  c.particles = "grain: {diameter: 1 mm, density: 1040 kg/m^3, count: 250}";
  c.cell = "4 mm";
  c.contact = fmt::format("{{{}, restitution: {}}}", law.parameters, restitution);
  const auto settled = small_bed(text_of(c));
  const double hard = limit_of(settled->steps, "contact time").hard;
  ParticleStore particles = empty_store(settled->simulation->particles().fields.rotation);
  particles.copy_rows(settled->simulation->particles());
  shake(particles, 0.05);
  c.time = "dt: " + seconds(hard) + ", gas_dt: " + seconds(hard);
  c.bed = "fill: none";
  c.particles = "grain: {diameter: 1 mm, density: 1040 kg/m^3}";
  const auto bed = small_bed(text_of(c), &particles);
  const double before = mechanical_energy(*bed->simulation), shaken = energy_of(bed->simulation->particles());
  Watch watch(*bed);
  double most = 0;   // [J], above the start
  for (int n = 0; n < 1500 * Watch::longer(); ++n) {
    watch.step();
    most = std::max(most, mechanical_energy(*bed->simulation) - before);
  }
  std::printf("  dt %.3g s: gained at most %.3g of what shook it, overlap %.3f\n", hard, most / shaken, watch.overlap);
  EXPECT_LT(most, shaken);
  watch.expect_sound(0.10);
}

INSTANTIATE_TEST_SUITE_P(Laws, AtTheHardTimeStep, testing::Combine(testing::ValuesIn(k_laws), testing::Values(0.01, 0.5, 1.0)),
                         [](const auto& info) {
                           return fmt::format("{}_{}", std::get<0>(info.param).name, static_cast<int>(100 * std::get<1>(info.param)));
                         });

}  // namespace similitude::test
