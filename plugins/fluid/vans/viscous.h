#pragma once
/// Viscous force per volume, div(tau) with tau = mu (grad u + grad u^T - 2/3 div u I), at the faces.

#include "stencils.h"

namespace similitude::vans {

/// One viscosity everywhere, or with what motion below the cells adds.
struct Viscosity {
  double molecular = 0;                            // [Pa s]
  const double* added_in_cells = nullptr;          // [Pa s]; null: nothing is added
  const std::vector<double>* added_on_faces = nullptr;   // [Pa s], faces of the component: means of their cells
};

/// tension[site] [Pa] on the sides along one direction. Along the axis the divergence of u enters (cells, [1/s]); across
/// it the velocities of the crossing component do.
void tension_along(const Component& component, const Viscosity& viscosity, double spacing, const std::vector<double>& velocity,
                   const std::vector<double>& divergence, std::vector<double>& tension);
void tension_across(const Component& component, std::size_t direction, const Viscosity& viscosity,
                    const std::array<double, 3>& spacing, const std::vector<double>& velocity, const std::vector<double>& crossing, std::vector<double>& tension);

/// force[active face] [N/m^3] += d(tension)/d(direction). The tension beyond a pressure patch equals the one before it.
void pull(const Component& component, std::size_t direction, double spacing, const std::vector<double>& tension,
          std::vector<double>& force);

/// [s], beyond it the explicit viscous term is unstable: eigenvalues of div(tau) / rho reach 4/3 mu/rho sum of 4/h^2.
double viscous_limit(double density, double viscosity, const std::array<double, 3>& spacing);

}  // namespace similitude::vans
