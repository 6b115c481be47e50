#include "stepper/bed.h"

#include <algorithm>
#include <filesystem>

#include "output/sha256.h"
#include "particles/bed_cache.h"
#include "stepper/stop_signal.h"

namespace similitude {

StoreFields store_fields(const Assembly& assembly) {
  return {.rotation = assembly.rotation(), .coupling = true, .added_mass = assembly.added_mass()};
}

namespace {

std::string sha256_of_contact_plugin(const Assembly& assembly) {
  const auto is_it = [&](const PluginEntry& plugin) { return plugin.descriptor == &assembly.contact.descriptor(); };
  const auto entry = std::ranges::find_if(assembly.plugins, is_it);
  return entry != assembly.plugins.end() ? sha256_of_file(entry->file) : "";
}

FillOptions fill_options(const Assembly& assembly, const TimeSteps& steps,
                         std::function<void(double fraction, const std::string& stage)> progress) {
  return {.dt = steps.dt,
          .length_ratio = assembly.ratios.length,
          .diameter_ratio = assembly.ratios.diameter,
          .density_ratio = assembly.ratios.particle_density,
          .velocity_ratio = assembly.ratios.velocity,
          .softer_law = [&assembly](double factor) { return softened_contact(assembly, factor); },
          .progress = std::move(progress),
          .cache_folder = cache_folder_of_beds(),
          .law_sha256 = assembly.model.bed.kind == FillKind::settle ? sha256_of_contact_plugin(assembly) : ""};
}

}  // namespace

StartingBed fill_bed(const Assembly& assembly, const TimeSteps& steps,
                     std::function<void(double fraction, const std::string& stage)> progress) {
  StartingBed bed{.particles = ParticleStore(store_fields(assembly)), .filled = {}};
  const auto or_leave = [progress = std::move(progress)](double fraction, const std::string& stage) {
    if (StopSignal::received() != 0) throw Interrupted();
    if (progress) progress(fraction, stage);
  };
  bed.filled = fill_bed(bed.particles, assembly.model, assembly.contact, fill_options(assembly, steps, or_leave));
  return bed;
}

bool settled_bed_is_kept(const Assembly& assembly, const TimeSteps& steps) {
  const FillOptions options = fill_options(assembly, steps, {});
  if (!assembly.model.bed.cache || options.cache_folder.empty()) return false;
  const std::string key = bed_key(assembly.model, assembly.contact, options);
  return std::filesystem::exists(bed_cache_file(options.cache_folder, key));
}

}  // namespace similitude
