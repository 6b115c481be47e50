#include "stepper/effect_price.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <memory>
#include <span>
#include <utility>

#include <similitude/sphere.h>

#include "coupling/scalar_plan.h"
#include "particles/contact_effects.h"
#include "particles/engine.h"
#include "stepper/bed.h"
#include "stepper/effects.h"
#include "stepper/inspection.h"
#include "stepper/seconds_since.h"
#include "stepper/simulation.h"

namespace similitude {
namespace {

constexpr int k_particles_per_edge = 12;
constexpr double k_particles = k_particles_per_edge * k_particles_per_edge * k_particles_per_edge;
constexpr int k_repetitions = 4;

/// A cube of spheres of the first class, slightly overlapping, with as many neighbours as in a settled bed.
struct CalibrationBed {
  ModelScene scene;
  ParticleStore particles;
};
CalibrationBed calibration_bed(const Assembly& assembly) {
  CalibrationBed bed{.scene = assembly.model, .particles = ParticleStore(store_fields(assembly))};
  const ParticleClass& species = assembly.model.particles.front();
  const double pitch = 0.999 * species.diameter;
  const double edge = pitch * k_particles_per_edge;
  bed.scene.size = {edge, edge, edge};
  bed.scene.patches.clear();
  bed.scene.baffles.clear();
  bed.scene.periodic = {false, false, false};
  std::uint64_t id = 0;
  for (int k = 0; k < k_particles_per_edge; ++k) {
    for (int j = 0; j < k_particles_per_edge; ++j) {
      for (int i = 0; i < k_particles_per_edge; ++i) {
        bed.particles.add(id++, 0, pitch * (i + 0.5), pitch * (j + 0.5), pitch * (k + 0.5), species.diameter / 2,
                          species.density * sphere_volume(species.diameter));
      }
    }
  }
  return bed;
}

/// [s], what the effects add to a sub-step of the small packing: with them and without.
double seconds_in_contacts(const Assembly& assembly, const TimeSteps& steps) {
  constexpr int k_warm_up = 10, k_sub_steps = 25;
  const EngineOptions options{.dt = steps.dt, .gravity = assembly.model.gravity};
  const auto best_of = [&](std::span<const EffectModel> effects) {
    CalibrationBed bed = calibration_bed(assembly);
    Engine engine(bed.particles, bed.scene, assembly.contact, options, effects);
    engine.advance(k_warm_up);
    double best = std::numeric_limits<double>::infinity();
    for (int i = 0; i < k_repetitions; ++i) {
      const auto start = std::chrono::steady_clock::now();
      engine.advance(k_sub_steps);
      best = std::min(best, seconds_since(start) / k_sub_steps);
    }
    return best;
  };
  return std::max(0.0, best_of(assembly.effects) - best_of({}));
}

/// [s], what stands in a gas step for effects alone: passes over particles and cells, transport, exchange and flows through contacts,
/// by the clocks of a step of the small packing, in as many cells per particle as the case has. The assembly is no longer the case's.
double seconds_around_sub_steps(Assembly& assembly, const TimeSteps& case_steps) {
  constexpr double k_fewest = 2, k_most = 16;        // cells along an edge: a bed without freeboard, a nearly empty one
  constexpr std::int64_t k_most_sub_steps = 50;      // they are not what is measured
  const double cells_per_particle = static_cast<double>(assembly.grid->cell_count()) / static_cast<double>(expected_particles(assembly.model));
  const double edge = std::clamp(std::round(std::cbrt(cells_per_particle * k_particles)), k_fewest, k_most);
  CalibrationBed bed = calibration_bed(assembly);
  assembly.model = bed.scene;
  for (std::size_t axis = 0; axis < 3; ++axis) assembly.model.cell[axis] = assembly.model.size[axis] / edge;
  assembly.grid = std::make_unique<Grid>(assembly.model);
  assembly.scalars = plan_scalars(assembly.model, assembly.effects);
  TimeSteps steps = case_steps;
  steps.sub_steps = std::min(steps.sub_steps, k_most_sub_steps);
  Simulation step_of(assembly, steps, std::move(bed.particles), [](const std::string&) {});
  const auto spent = [&] {
    double seconds = 0;
    for (const Stage& stage : step_of.stages())
      if (stage.name.starts_with("effect") || stage.name.starts_with("scalars")) seconds += stage.seconds;
    return seconds;
  };
  step_of.step();
  double best = std::numeric_limits<double>::infinity();
  for (int i = 0; i < k_repetitions; ++i) {
    const double before = spent();
    step_of.step();
    best = std::min(best, spent() - before);
  }
  return best;
}

/// A price needs some number where the case must give one.
void give_typical_values(ModelChoice& effect, const similitude_descriptor& model) {
  for (std::size_t i = 0; i < effect.parameters.size(); ++i) {
    const similitude_parameter& row = model.parameters[i];
    if (row.required != 0 && std::isnan(effect.parameters[i].real)) effect.parameters[i].real = row.typical_maximum;
  }
}

}  // namespace

double effect_price(const RealScene& scene, const TimeSteps& steps, const Catalogue& catalogue, const std::string& id) {
  RealScene with = scene;
  with.models.effects_auto = false;
  std::erase_if(with.models.effects, [&](const ModelChoice& effect) { return effect.id != id; });
  if (with.models.effects.empty()) with.models.effects.push_back(effect_with_defaults(*catalogue.find("effect", id)));
  for (ModelChoice& choice : with.models.effects) give_typical_values(choice, *catalogue.find("effect", id)->descriptor);
  Assembly assembly = assemble(with, catalogue);
  const similitude_effect_functions& passes = assembly.effects.front().functions();
  const auto expected = static_cast<double>(expected_particles(assembly.model));
  const auto gas_steps = static_cast<double>(steps.gas_steps_until(assembly.model.time.end));
  double price = 0;
  if (passes.contacts != nullptr && (needs_of(assembly.effects.front()).adds & SIMILITUDE_ADDS_FLOW_ALONE) == 0)
    price += seconds_in_contacts(assembly, steps) * gas_steps * static_cast<double>(steps.sub_steps);
  if (passes.particles != nullptr || passes.cells != nullptr || passes.quantity_count > 0)
    price += seconds_around_sub_steps(assembly, steps) * gas_steps;
  return price * expected / k_particles;
}

}  // namespace similitude
