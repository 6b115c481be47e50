#pragma once
/// A drag plugin asked for one value, through its block. Its values are tested elsewhere against published numbers.

#include <stdexcept>

#include "loader/catalogue.h"

namespace similitude::test {

/// K [kg/s] of one particle of `diameter` [m] in gas of `density` [kg/m^3] and `viscosity` [Pa s].
inline double exchange_coefficient(const DragModel& drag, double diameter, double density, double viscosity, double gas_fraction,
                                   double slip_speed) {
  constexpr int k_rows = SIMILITUDE_ROW_MULTIPLE;
  struct alignas(64) Column {
    explicit Column(double value) {
      for (double& v : values) v = value;
    }
    double values[k_rows];
  };
  const Column diameters(diameter), fractions(gas_fraction), slips(slip_speed), densities(density), viscosities(viscosity);
  Column exchange(0);
  const similitude_drag_block block{.struct_size = sizeof(similitude_drag_block),
                                    .rows = k_rows,
                                    .diameter = diameters.values,
                                    .gas_fraction = fractions.values,
                                    .slip_speed = slips.values,
                                    .gas_density = densities.values,
                                    .gas_viscosity = viscosities.values,
                                    .sauter_diameter = nullptr,
                                    .cell_size = nullptr,
                                    .exchange = exchange.values};
  similitude_status status{};
  drag.functions().exchange(drag.instance(), &block, &status);
  if (status.code != 0) throw std::runtime_error(status.text);
  return exchange.values[0];
}

}  // namespace similitude::test
