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

/// force[active face] [N/m^3] = div(tau) of one component. Along its axis the divergence of u enters (cells, [1/s]); across it
/// the velocities of the crossing components do. `tension` is room for [Pa] on its sites. The tension beyond a pressure patch
/// equals the one before it.
void viscous_force_on(const Component& component, const Viscosity& viscosity, const std::array<double, 3>& spacing,
                      const FaceFields& velocity, const std::vector<double>& divergence, SiteFields& tension,
                      std::vector<double>& force);

/// [s], beyond it the explicit viscous term is unstable: eigenvalues of div(tau) / rho reach 4/3 mu/rho sum of 4/h^2.
double viscous_limit(double density, double viscosity, const std::array<double, 3>& spacing);

}  // namespace similitude::vans
