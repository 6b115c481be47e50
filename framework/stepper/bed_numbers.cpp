#include "stepper/bed_numbers.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>

#include <fmt/format.h>
#include <similitude/sphere.h>

#include "loader/number_text.h"
#include "particles/impacts.h"
#include "scene/messages.h"
#include "similarity/audit.h"
#include "similarity/groups.h"
#include "stepper/guards.h"

namespace similitude {
namespace {

constexpr double k_incompressible = 0.3;       // Mach: density then changes by less than 5 %
constexpr double k_sound_in_air = 343;         // [m/s], dry, 20 °C
constexpr double k_atmosphere = 101325;        // [Pa]
constexpr double k_heat_ratio = 1.4;           // of gases of two atoms
constexpr double k_densest_gas = 10;           // [kg/m^3], beyond it this is a liquid or a gas under a pressure that no case tells

/// [m/s], of an ideal gas of this density at atmospheric pressure, but not below air's: a case gives no absolute pressure, and
/// a gas that is denser than air may be heavy or compressed. Infinite where nothing can be said.
double speed_of_sound(double density) {
  if (!(density > 0) || density > k_densest_gas) return std::numeric_limits<double>::infinity();
  return std::max(k_sound_in_air, std::sqrt(k_heat_ratio * k_atmosphere / density));
}

double finite_or_nothing(double value) { return std::isfinite(value) ? value : std::numeric_limits<double>::quiet_NaN(); }

// --------------------------------------------------------------------------------------------------- how deep grains press

/// Half the period of a spring force ~ overlap^p over (largest overlap / speed): pi if linear, 2.943 of Hertz. From the energy,
/// 2 times the integral of 1/sqrt(1 - x^(p+1)) from 0 to 1.
double duration_of(double p) {
  const double a = 1 / (p + 1);
  return 2 * std::sqrt(std::numbers::pi) * std::tgamma(1 + a) / std::tgamma(0.5 + a);
}

/// One pair as a spring: by how contact times fall with the speed, t_c ~ v^(-(p - 1)/(p + 1)).
struct Spring {
  double exponent, duration;   // p, duration_of(p)
  double time, speed;          // [s] of an impact at [m/s]
  double mass;                 // [kg], effective

  double falling() const { return (exponent - 1) / (exponent + 1); }
  double overlap_at(double v) const { return v * time * std::pow(v / speed, -falling()) / duration; }   // [m]
  /// [m], under a force [N]: a spring holds F delta/(p + 1) = m v^2/2 at the end of an impact.
  double overlap_under(double force) const {
    const double there = mass * (exponent + 1) / 2 * speed * speed / overlap_at(speed);   // [N], at the end of the known impact
    return overlap_at(speed) * std::pow(force / there, 1 / exponent);
  }
};

constexpr double k_twice = 2;   // the ratio of the speeds that a contact law is asked at

/// False for a law that says nothing finite.
bool spring_of(const ContactModel& law, const Impact& impact, double speed, Spring& spring) {
  const double slow = impact.contact_time(law, speed), fast = impact.contact_time(law, k_twice * speed);
  if (!std::isfinite(slow) || !std::isfinite(fast) || !(fast > 0)) return false;
  const double falling = std::clamp(std::log(slow / fast) / std::log(k_twice), 0.0, 0.9);
  const double exponent = (1 + falling) / (1 - falling);
  spring = {exponent, duration_of(exponent), slow, speed, impact.effective_mass};
  return true;
}

// -------------------------------------------------------------------------------------------------------- the warnings

std::string warning(const SourceMark& mark, const std::string& path, const std::string& what, const std::string& fix) {
  return InputError(mark, path, what, fix).what();
}

void warn_of_inlets(const Assembly& assembly, std::vector<std::string>& warnings) {
  if (!assembly.coupled()) return;
  const double sound = speed_of_sound(assembly.real.gas_density);
  for (const Patch& patch : assembly.real.patches) {
    if (patch.kind != PatchKind::velocity) continue;
    const std::string path = "scene.patches." + patch.name + ".velocity";
    if (std::abs(patch.velocity) > k_incompressible * sound)
      warnings.push_back(warning(patch.mark, path,
                                 fmt::format("{:.6g} m/s is Mach {:.2g}; {} is incompressible, good to Mach {} ({} m/s in {}).", patch.velocity,
                                             std::abs(patch.velocity) / sound, assembly.fluid.descriptor().id, k_incompressible,
                                             two_digits(k_incompressible * sound), sound > k_sound_in_air ? "a gas so light" : "air"),
                                 "Is the unit right?"));
    if (patch.velocity < 0)
      warnings.push_back(warning(patch.mark, path, fmt::format("{:.6g} m/s sucks gas out of the bed.", patch.velocity),
                                 "Write it without the minus to blow in; where gas only leaves, give the patch a pressure instead."));
  }
}

void warn_of_soft_springs(const Assembly& assembly, std::vector<std::string>& warnings) {
  const PredictedOverlap overlap = predicted_overlap(assembly);
  const double rest = overlap.at_rest / k_overlap_to_warn, fall = overlap.in_a_fall / k_overlap_to_warn;
  if (!(rest > 1) && !(fall > 1)) return;
  // Force ~ stiffness overlap^p, energy ~ stiffness overlap^(p + 1).
  const double harder = std::max(std::pow(rest, overlap.exponent), std::pow(fall, overlap.exponent + 1));
  const std::string what = rest > 1 ? fmt::format("the bed's own weight presses its lowest grains in by about {} % of a diameter", two_digits(100 * overlap.at_rest))
                                    : fmt::format("a grain that falls the bed's height onto another presses in by about {} % of a diameter",
                                                  two_digits(100 * overlap.in_a_fall));
  warnings.push_back(warning(assembly.real.models.contact.mark, "models.contact",
                             what + fmt::format("; more than {:.0f} % means little, and a run stops at {:.0f} %.", 100 * k_overlap_to_warn,
                                                100 * k_overlap_to_stop),
                             fmt::format("Take contacts {} times as hard.", two_digits(std::ceil(10 * harder) / 10))));
}

}  // namespace

BedNumbers bed_numbers(const RealScene& scene) {
  BedNumbers numbers;
  if (scene.particles.empty()) return numbers;
  const similitude_bed bed = describe(scene);
  const double gas_fraction = gas_fraction_at_minimum(scene);
  double weight = 0;   // [N]
  for (const ParticleClass& species : scene.particles) {
    const SphereInGas sphere{species.drag_diameter, species.density, scene.gas_density, scene.gas_viscosity, bed.gravity};
    ClassNumbers one{species.name, species.known_count(), NAN, NAN};
    double alike = species.spheres_alike();
    if (scene.particles.size() == 1 && scene.bed.height) one.count = alike = bed.particle_count;
    if (archimedes(sphere) > 0 && std::isfinite(archimedes(sphere))) {
      one.minimum_fluidisation = finite_or_nothing(minimum_fluidisation_ergun(sphere, gas_fraction));
      one.terminal_velocity = finite_or_nothing(terminal_velocity(sphere, schiller_naumann));
    }
    weight += alike * (species.density - scene.gas_density) * sphere_volume(species.diameter) * bed.gravity;
    numbers.classes.push_back(one);
  }
  numbers.pressure = weight / (scene.size[0] * scene.size[1]);
  numbers.height = bed.bed_height;
  numbers.cell_over_diameter = *std::ranges::min_element(scene.cell) / largest_diameter(scene);
  return numbers;
}

std::string in_words(const BedNumbers& numbers) {
  std::string text;
  const auto add = [&](const std::string& part) { text += (text.empty() ? "" : ", ") + part; };
  for (const ClassNumbers& one : numbers.classes)
    if (one.count > 0) add(fmt::format("{:.0f} x {}", one.count, one.name));
  if (numbers.pressure > 0) add(fmt::format("{:.3g} Pa", numbers.pressure));
  if (numbers.height > 0) add(fmt::format("about {} mm settled", two_digits(1e3 * numbers.height)));
  for (const ClassNumbers& one : numbers.classes) {
    const std::string of = numbers.classes.size() > 1 ? " of " + one.name : "";
    if (std::isfinite(one.minimum_fluidisation)) add(fmt::format("u_mf{} {:.3g} m/s (Ergun)", of, one.minimum_fluidisation));
    if (std::isfinite(one.terminal_velocity)) add(fmt::format("u_t{} {:.3g} m/s (Schiller-Naumann)", of, one.terminal_velocity));
  }
  if (numbers.cell_over_diameter > 0) add(fmt::format("cells of {:.3g} diameters", numbers.cell_over_diameter));
  return text;
}

PredictedOverlap predicted_overlap(const Assembly& assembly) {
  const ModelScene& scene = assembly.model;
  const similitude_bed bed = describe(scene);
  PredictedOverlap largest;
  if (!(bed.bed_height > 0) || !(bed.gravity > 0)) return largest;
  std::vector<Sphere> classes;
  double solids = 0, mass = 0;   // [m^3], [kg]: what lies on the bottom is a mixture
  for (const ParticleClass& species : scene.particles) {
    const double volume = sphere_volume(species.diameter);
    classes.push_back({species.density * volume, species.diameter / 2});
    const double count = scene.particles.size() == 1 ? 1 : species.spheres_alike();
    solids += count * volume;
    mass += count * volume * species.density;
  }
  if (!(solids > 0)) return largest;
  const double pressure = mass / solids * bed.gravity * k_settled_packing * bed.bed_height;   // [Pa]
  const double fall = std::sqrt(2 * bed.gravity * bed.bed_height);                            // [m/s]
  for (const Impact& impact : possible_impacts(classes, assembly.contact)) {
    if (impact.materials.first != impact.materials.second) continue;   // grain on grain of one kind
    const double diameter = scene.particles[impact.materials.first].diameter;
    Spring spring{};
    if (!spring_of(assembly.contact, impact, fall, spring)) continue;
    const double rest = spring.overlap_under(pressure * diameter * diameter) / diameter, in_a_fall = spring.overlap_at(fall) / diameter;
    if (std::max(rest, in_a_fall) > std::max(largest.at_rest, largest.in_a_fall)) largest = {rest, in_a_fall, spring.exponent};
  }
  return largest;
}

std::vector<std::string> bed_warnings(const Assembly& assembly) {
  std::vector<std::string> warnings;
  warn_of_inlets(assembly, warnings);
  warn_of_soft_springs(assembly, warnings);
  return warnings;
}

}  // namespace similitude
