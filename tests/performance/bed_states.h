#pragma once
/// Settled and agitated beds that every code starts from, as LAMMPS data files.

#include <string>

#include "particles/store.h"

namespace similitude::bench {

/// Pours `count` particles and lets them come to rest.
ParticleStore poured_bed(std::size_t count);
/// Copies of a settled bed on top of each other, every second one mirrored, cut off at `count` particles and brought to rest.
ParticleStore piled_bed(const ParticleStore& settled, int copies, std::size_t count);

/// Turns a settled bed into one of these, all reproducible:
///   settled  as it is
///   dense    velocities of 0.1 m/s (standard deviation per component) in the packed bed
///   kick     the bed stretched by 1.3 in height (solids fraction 0.45), 0.3 m/s: collisional, like the dilute part of a bed
///   spout    the 5 % of particles nearest to the middle plane rise as a dilute core (solids fraction 0.2) at 2 m/s with 0.3 m/s
///            of scatter; the annulus on both sides rests
/// False if there is no such state.
bool put_into_state(ParticleStore& bed, const std::string& state);

ParticleStore read_bed(const std::string& file);
void write_bed(const ParticleStore& bed, const std::string& file);

/// What positions and velocities say, so that no code's own bookkeeping is believed.
struct Observables {
  double coordination = 0;      // [-], touching partners per particle, walls not counted
  double top = 0;               // [m], height that 99 % of the centres lie under
  double kinetic_energy = 0;    // [J] per particle, of translation
  double normal_force = 0;      // [N], mean size over touching pairs, spring and dashpot
  std::size_t pairs = 0;        // touching
};
Observables observe(const ParticleStore& bed);

}  // namespace similitude::bench
