#include "stepper/effect_price.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <memory>
#include <span>

#include <similitude/sphere.h>

#include "coupling/effect_pass.h"
#include "particles/engine.h"
#include "stepper/bed.h"
#include "stepper/effects.h"
#include "stepper/inspection.h"
#include "stepper/seconds_since.h"
#include "stepper/simulation.h"

namespace similitude {
namespace {

/// A cube of spheres of the first class, slightly overlapping, with as many neighbours as in a settled bed.
struct CalibrationBed {
  ModelScene scene;
  ParticleStore particles;
};
CalibrationBed calibration_bed(const Assembly& assembly, int particles_per_edge) {
  CalibrationBed bed{.scene = assembly.model, .particles = ParticleStore(store_fields(assembly))};
  const ParticleClass& species = assembly.model.particles.front();
  const double pitch = 0.999 * species.diameter;
  const double edge = pitch * particles_per_edge;
  bed.scene.size = {edge, edge, edge};
  bed.scene.patches.clear();
  bed.scene.baffles.clear();
  bed.scene.periodic = {false, false, false};
  std::uint64_t id = 0;
  for (int k = 0; k < particles_per_edge; ++k) {
    for (int j = 0; j < particles_per_edge; ++j) {
      for (int i = 0; i < particles_per_edge; ++i) {
        bed.particles.add(id++, 0, pitch * (i + 0.5), pitch * (j + 0.5), pitch * (k + 0.5), species.diameter / 2,
                          species.density * sphere_volume(species.diameter));
      }
    }
  }
  return bed;
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
  constexpr int k_particles_per_edge = 12;
  constexpr int k_warm_up = 10, k_sub_steps = 25, k_repetitions = 4;
  RealScene with = scene;
  with.models.effects_auto = false;
  std::erase_if(with.models.effects, [&](const ModelChoice& effect) { return effect.id != id; });
  if (with.models.effects.empty()) with.models.effects.push_back(effect_with_defaults(*catalogue.find("effect", id)));
  for (ModelChoice& choice : with.models.effects) give_typical_values(choice, *catalogue.find("effect", id)->descriptor);
  const Assembly assembly = assemble(with, catalogue);
  const EffectModel& effect = assembly.effects.front();
  CalibrationBed bed = calibration_bed(assembly, k_particles_per_edge);
  const double scale = static_cast<double>(expected_particles(assembly.model)) / static_cast<double>(bed.particles.size());
  const auto gas_steps = static_cast<double>(steps.gas_steps_until(assembly.model.time.end));
  double price = 0;
  if (effect.functions().contacts) {
    const EngineOptions options{.dt = steps.dt, .gravity = assembly.model.gravity};
    const auto best_of = [&](std::span<const EffectModel> effects) {
      CalibrationBed own = calibration_bed(assembly, k_particles_per_edge);
      Engine engine(own.particles, own.scene, assembly.contact, options, effects);
      engine.advance(k_warm_up);
      double best = std::numeric_limits<double>::infinity();
      for (int i = 0; i < k_repetitions; ++i) {
        const auto start = std::chrono::steady_clock::now();
        engine.advance(k_sub_steps);
        best = std::min(best, seconds_since(start) / k_sub_steps);
      }
      return best;
    };
    price += std::max(0.0, best_of(assembly.effects) - best_of({})) * scale * gas_steps * static_cast<double>(steps.sub_steps);
  }
  if (effect.functions().particles) {
    for (std::size_t axis = 0; axis < 3; ++axis) bed.scene.cell[axis] = bed.scene.size[axis] / 4;
    const Grid grid(bed.scene);
    std::unique_ptr<GasMotion> motion;
    if (assembly.effect_reads != 0) motion = std::make_unique<GasMotion>(bed.scene, grid, assembly.coupled(), assembly.effect_reads);
    EffectPass pass(bed.scene, grid, effect, motion.get());
    const Column<double> fraction(grid.cell_count(), 0.5);
    double best = std::numeric_limits<double>::infinity();
    for (int i = 0; i < k_repetitions; ++i) {
      const auto start = std::chrono::steady_clock::now();
      pass.apply(bed.particles, fraction, steps.gas_dt());
      best = std::min(best, seconds_since(start));
    }
    price += best * scale * gas_steps;
  }
  return price;
}

}  // namespace similitude
