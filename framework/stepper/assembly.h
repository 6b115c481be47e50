#pragma once
/// Which models meet in a case: every plugin created, the real bed scaled to the simulated one. Done once, at start.

#include <memory>
#include <string>
#include <vector>

#include "coupling/exchange_coefficient.h"
#include "coupling/scalar_plan.h"
#include "fluid/grid.h"
#include "loader/catalogue.h"
#include "output/map_back.h"
#include "scene/scene.h"
#include "similarity/ratios.h"

namespace similitude {

struct Assembly {
  RealScene real;
  ModelScene model;
  similitude_ratios ratios{};
  ResultRatios results;
  std::unique_ptr<Grid> grid;            // of the simulated bed; outlives the fluid model's use of it
  ScalingModel scaling;
  ContactModel contact;
  DragModel drag;
  FluidModel fluid;
  std::vector<EffectModel> effects;      // in the order of the case
  unsigned effect_reads = 0;             // SIMILITUDE_READS_... of all effects together
  unsigned effect_adds = 0;              // SIMILITUDE_ADDS_...
  ScalarPlan scalars;                    // what the effects carry
  similitude_contact_needs contact_needs{};
  similitude_fluid_needs fluid_needs{};
  std::vector<PluginEntry> plugins;      // in use, for the manifest
  std::vector<std::string> warnings;     // of the scaling, in words

  /// Particles have angular velocity.
  bool rotation() const {
    return contact_needs.rotation != 0 || (effect_reads & SIMILITUDE_READS_ANGULAR_VELOCITY) != 0;
  }
  bool added_mass() const { return (effect_adds & SIMILITUDE_ADDS_ADDED_MASS) != 0; }
  bool coupled() const { return fluid.functions().sees_particles != 0; }
  DragForm drag_form() const {
    return fluid_needs.drag_over_gas_fraction != 0 ? DragForm::over_gas_fraction : DragForm::as_given;
  }
};

/// Creates the models of the scene and the simulated bed. Throws InputError for a scene that does not fit its cells and
/// PluginError for a model that is missing or refuses its parameters.
Assembly assemble(const RealScene& scene, const Catalogue& catalogue);

/// How this case's results come back to the real bed.
MapBack map_back(const Assembly& assembly);

/// The contact law with its stiffness multiplied, for settling only.
ContactModel softened_contact(const Assembly& assembly, double stiffness_factor);

}  // namespace similitude
