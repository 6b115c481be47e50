#pragma once
/// Brings a crowded bed to rest under gravity: first apart and down with soft springs and long steps, then with the
/// case's own law. Stops when the bed rests, not after a number of steps.

#include <cstdint>

#include "loader/catalogue.h"
#include "particles/fill.h"
#include "particles/store.h"
#include "scene/scene.h"

namespace similitude {

/// Settles the particles in place and leaves them at rest. Returns the sub-steps it took. Throws SimulationError when the bed
/// does not come to rest.
std::int64_t settle(ParticleStore& particles, const ModelScene& scene, const ContactModel& law, const FillOptions& options);

/// [-], mean kinetic energy per particle over the mean m g d.
double agitation(const ParticleStore& particles, const ModelScene& scene);

}  // namespace similitude
