#include "stepper/bed.h"

namespace similitude {

StoreFields store_fields(const Assembly& assembly) {
  return {.rotation = assembly.rotation(), .coupling = true, .added_mass = assembly.added_mass()};
}

StartingBed fill_bed(const Assembly& assembly, const TimeSteps& steps,
                     std::function<void(double fraction, const std::string& stage)> progress) {
  StartingBed bed{.particles = ParticleStore(store_fields(assembly)), .filled = {}};
  const FillOptions options{.dt = steps.dt,
                            .length_ratio = assembly.ratios.length,
                            .diameter_ratio = assembly.ratios.diameter,
                            .density_ratio = assembly.ratios.particle_density,
                            .velocity_ratio = assembly.ratios.velocity,
                            .softer_law = [&assembly](double factor) { return softened_contact(assembly, factor); },
                            .progress = std::move(progress),
                            .cache_folder = cache_folder_of_beds()};
  bed.filled = fill_bed(bed.particles, assembly.model, assembly.contact, options);
  return bed;
}

}  // namespace similitude
