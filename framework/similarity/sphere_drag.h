#pragma once
/// A case's own drag law, asked for the speeds that the audit needs.

#include <functional>

#include <similitude/sphere_in_gas.h>

#include "loader/catalogue.h"

namespace similitude {

/// K [kg/s] of one particle as a function of gas fraction [-] and slip speed [m/s]. May be empty.
using SphereDrag = std::function<double(double gas_fraction, double slip_speed)>;

/// Of a drag model that was created for this sphere's bed and outlives the result; `cell` [m] for laws that ask for it.
SphereDrag sphere_drag(const DragModel& law, const SphereInGas& sphere, double cell);

/// [m/s], K u = V (rho_p - rho_f) g in an empty gas, by bisection to the last bit; K u must grow with u.
double terminal_velocity(const SphereInGas& sphere, const SphereDrag& drag);

/// [m/s], superficial: K(eps, U/eps) U = eps^2 V (rho_p - rho_f) g, model A's balance of drag, pressure gradient and weight.
double minimum_fluidisation(const SphereInGas& sphere, const SphereDrag& drag, double gas_fraction);

}  // namespace similitude
