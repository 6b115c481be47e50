#include "stepper/occurred.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include <fmt/format.h>

#include "coupling/cell_map.h"
#include "fluid/staggered.h"
#include "fluid/velocity_gradient.h"
#include "loader/number_text.h"

namespace similitude {

void Occurred::Sum::add(double value) {
  lowest = count == 0 ? value : std::min(lowest, value);
  highest = count == 0 ? value : std::max(highest, value);
  total += value;
  ++count;
}

similitude_range Occurred::Sum::range(double per) const {
  constexpr double k_unknown = std::numeric_limits<double>::quiet_NaN();
  if (count == 0) return {k_unknown, k_unknown, k_unknown};
  return {lowest / per, total / static_cast<double>(count) / per, highest / per};
}

void Occurred::observe(const Simulation& simulation) {
  const Grid& grid = *assembly_->grid;
  const ParticleStore& particles = simulation.particles();
  const Staggered mesh(grid.table());
  const CellMap map(grid);
  const auto nx = static_cast<std::size_t>(grid.cells(0)), ny = static_cast<std::size_t>(grid.cells(1));
  std::vector<double> turning(grid.cell_count());   // [1/s], |curl u|
  for (std::size_t c = 0; c < turning.size(); ++c) {
    const Triple cell{static_cast<Index>(c % nx), static_cast<Index>(c / nx % ny), static_cast<Index>(c / (nx * ny))};
    const VelocityGradient gradient = velocity_gradient(mesh, simulation.gas().velocity.data(), cell, simulation.time());
    const std::array<double, 3> curl = vorticity(gradient);
    turning[c] = std::hypot(curl[0], curl[1], curl[2]);
    strain_rate_.add(strain_rate(gradient));
  }
  for (std::size_t p = 0; p < particles.size(); ++p) {
    const Row &v = particles.velocity[p], &u = particles.gas[p];
    const std::size_t cell = map.cell_at(particles.position[p]);
    particle_speed_.add(std::hypot(v.x, v.y, v.z));
    slip_speed_.add(std::hypot(u.x - v.x, u.y - v.y, u.z - v.z));
    solids_fraction_.add(1 - simulation.exchange().gas_fraction[cell]);
    vorticity_.add(turning[cell]);
    if (!particles.fields.rotation) continue;
    const Row& w = particles.angular_velocity[p];
    angular_speed_.add(std::hypot(w.x, w.y, w.z));
  }
}

similitude_occurred Occurred::ranges() const {
  const ResultRatios& to = assembly_->results;
  similitude_occurred seen{};
  seen.struct_size = sizeof seen;
  seen.solids_fraction = solids_fraction_.range(1);
  seen.slip_speed = slip_speed_.range(to.velocity);
  seen.particle_speed = particle_speed_.range(to.velocity);
  seen.angular_speed = angular_speed_.range(to.angular_velocity);
  seen.vorticity = vorticity_.range(1 / to.time);
  seen.strain_rate = strain_rate_.range(1 / to.time);
  return seen;
}

std::vector<std::string> second_thoughts(const Models& models, const std::vector<EffectVerdict>& before,
                                         const std::vector<EffectVerdict>& after) {
  std::vector<std::string> thoughts;
  // A list in place of `auto` names the others too, or they would be lost.
  const auto others_of = [&](const std::string& id) {
    std::vector<std::string> ids;
    for (const ModelChoice& effect : models.effects)
      if (effect.id != id) ids.push_back(effect.id);
    return ids;
  };
  for (const EffectVerdict& now : after) {
    const auto then = std::ranges::find(before, now.id, &EffectVerdict::id);
    if (then == before.end()) continue;
    std::vector<std::string> list = others_of(now.id);
    const bool told_at_start = models.effects_auto && then->verdict == 1;   // auto takes what is called for, unless the solver cannot
    if (now.verdict == 1 && !now.chosen && !told_at_start) {
      list.push_back(now.id);
      thoughts.push_back(fmt::format("{} was left out, but what occurred calls for it: {}. Before the run: {}. {}.", now.id, now.because,
                                     two_digits(then->value),
                                     models.effects_auto ? "Write " + written_list(list) : "Add " + now.id + " to models.effects"));
    } else if (now.verdict == 0 && now.chosen) {
      thoughts.push_back(fmt::format("{} was in the run, but what occurred does not call for it: {}. Before the run: {}. It may be left out{}.",
                                     now.id, now.because, two_digits(then->value),
                                     models.effects_auto ? ": " + written_list(list) : " of models.effects"));
    }
  }
  return thoughts;
}

}  // namespace similitude
