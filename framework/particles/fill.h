#pragma once
/// Puts the particles of a scene into the simulated bed: settled under gravity, on a lattice, or from a file.
/// A settled bed is kept in a cache, so that the next run of the same bed starts at once.

#include <cstdint>
#include <functional>
#include <string>

#include "loader/catalogue.h"
#include "particles/store.h"
#include "scene/scene.h"

namespace similitude {

/// What filling needs beyond the scene.
struct FillOptions {
  double dt = 0;                                                    // [s], the case's own sub-step
  double length_ratio = 1;                                          // simulated / real, as the next three: files are real
  double diameter_ratio = 1;                                        // of what touches
  double density_ratio = 1;                                         // of particles
  double velocity_ratio = 1;
  std::function<ContactModel(double stiffness_factor)> softer_law;  // for settling; empty: the case's law throughout
  std::function<void(double fraction, const std::string& stage)> progress;   // 0 ... 1; may be empty; what it throws ends the filling
  std::string cache_folder;                                         // empty: cache_folder_of_beds()
  std::string law_sha256 = {};                                      // of the law's file: another build of it may settle another bed
};

struct FilledBed {
  double height = 0;            // [m], level of the settled bed: see bed_height()
  double solids_fraction = 0;   // [-], between the bottom and the level less two diameters, baffles excluded
  bool from_cache = false;
  std::int64_t sub_steps = 0;   // spent on settling
  std::string cache_file;       // read or written; empty: none
};

/// Adds the scene's particles to an empty store, at rest unless a file gives velocities, in the order of their ids 0, 1, 2, … The result depends on the
/// scene, the law and the seed alone: not on the number of threads, nor on whether it came from the cache.
/// Throws InputError when the particles do not fit or a file is wrong, SimulationError when the bed does not come to rest.
FilledBed fill_bed(ParticleStore& particles, const ModelScene& scene, const ContactModel& law, const FillOptions& options);

/// [m], height of the bed's level: the mean over columns of the cross-section, at least three diameters wide, of the top of
/// the highest particle. Between x low and high where given: the level of one channel. 0 for an empty store.
double bed_height(const ParticleStore& particles, const ModelScene& scene);
double bed_height(const ParticleStore& particles, const ModelScene& scene, const Interval& x);

/// [-], volume of spheres over room below `height` [m], the baffles' bodies not counted as room.
double solids_fraction_below(const ParticleStore& particles, const ModelScene& scene, double height);

/// ${XDG_CACHE_HOME:-~/.cache}/similitude/beds; empty if neither is set.
std::string cache_folder_of_beds();

}  // namespace similitude
