#include <similitude/scaling_families.h>

namespace {
using namespace similitude;

/// Ratios by hand. What is left out follows the rules that the other laws share: the Froude number and the softness are kept.
struct Custom {
  double length, diameter, drag_diameter, particle_density, gas_density, gas_viscosity, velocity, time, stiffness, modulus,
      energy_loss, parcel_weight;   // [-], simulated over real; NaN: not given

  static void parameters(Parameters<Custom>& p) {
    using L = Custom;
    const auto ratio = [&p](const char* name, double L::*member, std::optional<double> def, const char* doc) {
      p.real(name, member, {.def = def, .min = 1e-9, .max = 1e9, .doc = doc});
    };
    const auto size = [&p](const char* name, double L::*member, const char* doc) {
      p.real(name, member, {.min = 1e-9, .max = 1e9, .typical_min = 1.0 / 16, .typical_max = 4, .doc = doc});
    };
    size("length", &L::length, "Of the bed, simulated over real as all ratios.");
    size("diameter", &L::diameter, "Of what touches.");
    ratio("drag_diameter", &L::drag_diameter, not_given, "Of what the gas sees; the diameter if left out.");
    ratio("particle_density", &L::particle_density, 1, "Of the particles' material.");
    ratio("gas_density", &L::gas_density, 1, "Of the gas.");
    ratio("gas_viscosity", &L::gas_viscosity, 1, "Of the gas.");
    ratio("velocity", &L::velocity, not_given, "Of gas and particles; sqrt(length) if left out, which keeps the Froude number.");
    ratio("time", &L::time, not_given, "Of the flow; length / velocity if left out.");
    ratio("stiffness", &L::stiffness, not_given, "Of springs; particle_density x length x diameter if left out.");
    ratio("modulus", &L::modulus, not_given, "Of elastic moduli; particle_density x length if left out.");
    ratio("energy_loss", &L::energy_loss, 1, "Of 1 - e^2, e the restitution.");
    ratio("parcel_weight", &L::parcel_weight, 1, "Physical particles that one simulated particle stands for.");
  }

  static void set(double& ratio, double given) {
    if (!std::isnan(given)) ratio = given;
  }

  Ratios ratios(const Bed&) const {
    Ratios r = froude_scaled(length, diameter);
    set(r.drag_diameter, drag_diameter);
    if (!std::isnan(velocity)) {
      r.velocity = velocity;
      r.time = length / velocity;
    }
    set(r.time, time);
    r.particle_density = particle_density;
    r.gas_density = gas_density;
    r.gas_viscosity = gas_viscosity;
    keep_softness(r);
    set(r.stiffness, stiffness);
    set(r.modulus, modulus);
    r.energy_loss = energy_loss;
    r.parcel_weight = parcel_weight;
    return r;
  }
};

}  // namespace

SIMILITUDE_SCALING_LAW(Custom, "custom", "1.0.0", "Ratios by hand", "Similitude authors")
