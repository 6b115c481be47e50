#pragma once
/// Between the simulated bed and every number a user reads. Everything handed to this folder is the simulated bed's,
/// times included; everything that leaves it is the real bed's. Settings (heights, sizes, end time) are the real bed's.

#include <similitude/abi.h>

#include <string>

#include "scene/scene.h"
#include "similarity/ratios.h"

namespace similitude {

struct MapBack {
  ResultRatios ratios;                   // simulated / real
  double gas_density = 1;                // simulated / real, for gas masses and mass flows
  double jet_ratio = 1;                  // J*, simulated / real jet momentum over bed weight
  std::string scaling_law = "identity";  // id of the scaling plugin

  double length(double simulated) const { return simulated / ratios.length; }                      // [m]
  double time(double simulated) const { return simulated / ratios.time; }                          // [s]
  double velocity(double simulated) const { return simulated / ratios.velocity; }                  // [m/s]
  double angular_velocity(double simulated) const { return simulated / ratios.angular_velocity; }  // [rad/s]
  double pressure(double simulated) const { return simulated / ratios.pressure; }           // [Pa], by bed weight
  double solids_mass(double simulated) const { return simulated / ratios.mass; }            // [kg]
  double gas_mass(double simulated) const;                                                  // [kg]
  double gas_mass_flow(double simulated) const;                                             // [kg/s]
  double material_diameter(double simulated) const { return simulated / ratios.diameter; }  // [m]
};

/// What this run's scaling law means for its results. J* = rho_f* v*^2 / p*: pressures are mapped by bed weight, so a
/// dynamic pressure comes back J* times too large.
MapBack map_back(const RealScene& real, const similitude_ratios& ratios);

/// In words for files: how values were mapped and which are off by how much.
std::string map_back_note(const MapBack& map);

}  // namespace similitude
