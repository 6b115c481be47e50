#include "doctor/trial_values.h"

#include <algorithm>
#include <cmath>

#include "similarity/ratios.h"

namespace similitude::doctor {
namespace {

constexpr double k_decades = 1e3;   // a range that spans more is walked by magnitude

double within(double low, double high, double position) {
  if (low > 0 && high / low > k_decades) return low * std::pow(high / low, position);
  return low + position * (high - low);
}

/// What fits the trial bed: contacts that overlap by a hundredth of a diameter, speeds of a jet.
double natural_size(int scales_as) {
  switch (scales_as) {
    case SIMILITUDE_SCALES_AS_LENGTH: return 0.05;       // [m]
    case SIMILITUDE_SCALES_AS_DIAMETER: return 1e-3;     // [m]
    case SIMILITUDE_SCALES_AS_TIME: return 0.1;          // [s]
    case SIMILITUDE_SCALES_AS_VELOCITY: return 1;        // [m/s]
    case SIMILITUDE_SCALES_AS_STIFFNESS: return 500;     // [N/m]
    case SIMILITUDE_SCALES_AS_MODULUS: return 1e7;       // [Pa]
    case SIMILITUDE_SCALES_AS_RESTITUTION: return 0.8;
    default: return 0.5;
  }
}

bool has_typical_range(const similitude_parameter& p) { return p.typical_minimum < p.typical_maximum; }
bool has_hard_range(const similitude_parameter& p) { return std::isfinite(p.minimum) && std::isfinite(p.maximum); }

double number(const similitude_parameter& p, double position) {
  double value = natural_size(p.scales_as);
  if (has_typical_range(p)) {
    value = within(p.typical_minimum, p.typical_maximum, position);
  } else if (has_hard_range(p)) {
    value = within(p.minimum, p.maximum, position);
  } else {
    value *= 0.5 + position;
  }
  if (p.type != SIMILITUDE_REAL) value = std::round(value);
  return std::clamp(value, p.minimum, p.maximum);
}

}  // namespace

RealScene trial_scene() {
  RealScene scene;
  scene.size = {0.15, 0.02, 1};
  scene.cell = {0.005, 0.005, 0.005};
  scene.gas_density = 1.225;
  scene.gas_viscosity = 1.79e-5;
  ParticleClass alumina;
  alumina.name = "alumina";
  alumina.diameter = alumina.drag_diameter = alumina.material_diameter = 1e-3;
  alumina.density = 1040;
  scene.particles.push_back(alumina);
  scene.bed.kind = FillKind::lattice;
  scene.bed.height = 0.1;
  Patch jet;
  jet.name = "jet";
  jet.extent = {Interval{0.07, 0.08}, Interval{0, 0.02}, Interval{0, 0}};
  jet.velocity = 10;
  Patch background;
  background.name = "background";
  background.extent = {Interval{0, 0.15}, Interval{0, 0.02}, Interval{0, 0}};
  background.rest = true;
  background.velocity = 0.46;
  scene.patches = {jet, background};
  scene.models.contact = {"contact", "spring", {{"restitution", 0.9, "", SIMILITUDE_SCALES_AS_RESTITUTION, true}}, {}};
  scene.models.scaling.kind = "scaling";
  scene.models.scaling.id = "it";
  return scene;
}

similitude_bed trial_bed() { return describe(trial_scene()); }

std::vector<similitude_value> trial_values(const similitude_descriptor& model, double position) {
  std::vector<similitude_value> values;
  for (std::uint32_t k = 0; k < model.parameter_count; ++k) {
    const similitude_parameter& p = model.parameters[k];
    similitude_value value{p.default_value, p.default_text};
    if (p.required != 0) value.real = p.type == SIMILITUDE_CHOICE ? 0 : number(p, position);
    values.push_back(value);
  }
  return values;
}

std::vector<similitude_value> moved_values(const similitude_descriptor& model, double position) {
  std::vector<similitude_value> values = trial_values(model, position);
  for (std::uint32_t k = 0; k < model.parameter_count; ++k) {
    const similitude_parameter& p = model.parameters[k];
    const bool moves = p.type == SIMILITUDE_REAL && !std::isnan(values[k].real);
    if (moves && (has_typical_range(p) || has_hard_range(p))) values[k].real = number(p, position);
  }
  return values;
}

}  // namespace similitude::doctor
