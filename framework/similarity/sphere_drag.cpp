#include "similarity/sphere_drag.h"

#include <stdexcept>
#include <string>

#include <similitude/sphere.h>

namespace similitude {
namespace {

double buoyant_weight(const SphereInGas& s) {
  return sphere_volume(s.diameter) * (s.particle_density - s.gas_density) * s.gravity;
}

/// The speed at which `force` reaches `needed`, from a first guess.
double speed_at(const std::function<double(double)>& force, double needed, double guess) {
  double low = 0, high = guess;
  while (force(high) < needed) high *= 2;
  while (true) {
    const double middle = 0.5 * (low + high);
    if (middle <= low || middle >= high) return high;
    (force(middle) < needed ? low : high) = middle;
  }
}

struct alignas(64) DragColumn {
  explicit DragColumn(double value) {
    for (double& v : values) v = value;
  }
  double values[SIMILITUDE_ROW_MULTIPLE];
};

}  // namespace

SphereDrag sphere_drag(const DragModel& law, const SphereInGas& sphere, double cell) {
  return [&law, sphere, cell](double gas_fraction, double slip_speed) {
    const DragColumn diameter(sphere.diameter), fraction(gas_fraction), slip(slip_speed), density(sphere.gas_density),
        viscosity(sphere.gas_viscosity), size(cell);
    DragColumn exchange(0);
    similitude_drag_block block{};
    block.struct_size = sizeof block;
    block.rows = SIMILITUDE_ROW_MULTIPLE;
    block.diameter = diameter.values;
    block.gas_fraction = fraction.values;
    block.slip_speed = slip.values;
    block.gas_density = density.values;
    block.gas_viscosity = viscosity.values;
    block.sauter_diameter = diameter.values;
    block.cell_size = size.values;
    block.exchange = exchange.values;
    similitude_status status{};
    law.functions().exchange(law.instance(), &block, &status);
    if (status.code != 0) throw PluginError(std::string(law.descriptor().id) + ": " + status.text);
    return exchange.values[0];
  };
}

double terminal_velocity(const SphereInGas& s, const SphereDrag& drag) {
  return speed_at([&](double u) { return drag(1, u) * u; }, buoyant_weight(s), s.gas_viscosity / (s.gas_density * s.diameter));
}

double minimum_fluidisation(const SphereInGas& s, const SphereDrag& drag, double eps) {
  return speed_at([&](double u) { return drag(eps, u / eps) * u; }, eps * eps * buoyant_weight(s),
                  minimum_fluidisation_ergun(s, eps));
}

}  // namespace similitude
