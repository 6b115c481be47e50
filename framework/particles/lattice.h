#pragma once
/// Where particles start: layer upon layer up the domain, clear of walls and baffles. Everything follows from the seed and
/// the particle's number by counter-based random numbers, so the places do not depend on how they are computed.

#include <array>
#include <cstdint>
#include <vector>

#include "scene/scene.h"

namespace similitude {

/// Uniform in [0, 1): the `draw`-th number of counter `counter` under `seed`. No state.
double counter_random(std::uint64_t seed, std::uint64_t counter, std::uint64_t draw);

/// The class of every particle, by id: the wanted counts, mixed.
std::vector<std::uint32_t> mixed_classes(const std::vector<std::int64_t>& counts, std::uint64_t seed);

using Places = std::vector<std::array<double, 3>>;   // [m], centres by id

/// Hexagonal layers of the largest diameter with a small clearance, nothing overlaps. Fewer places than classes where the
/// domain is full.
Places lattice_places(const ModelScene& scene, const std::vector<std::uint32_t>& classes);

/// As dense as a settled bed and as disordered: neighbours overlap until they have pushed each other apart. The density is
/// the same in every channel between baffles, so that the bed's level will be. Not limited by the domain's height.
Places crowded_places(const ModelScene& scene, const std::vector<std::uint32_t>& classes);

}  // namespace similitude
