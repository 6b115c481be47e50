#pragma once
/// Which materials can meet, and in which order their contact parameters stand.

#include <cstddef>
#include <span>
#include <string>
#include <vector>

#include "scene/scene.h"

namespace similitude {

/// What every wall, baffle and inlet is called where materials are paired.
inline constexpr const char* k_wall_material = "wall";

/// Two materials by number: particle classes in the scene's order, after the last class the wall. first <= second.
struct MaterialPair {
  std::size_t first = 0, second = 0;
  bool operator==(const MaterialPair&) const = default;
};

/// All pairs of classes, then every class with the wall: the order of a contact model's parameter sets.
std::vector<MaterialPair> material_pairs(std::size_t classes);

/// The place in that order of the pair of two materials, whichever comes first.
std::size_t pair_place(std::size_t classes, std::size_t one, std::size_t other);

/// "alumina-glass", "alumina-wall"
std::string pair_name(const std::vector<ParticleClass>& classes, const MaterialPair& pair);

/// The parameter sets of the contact model in that order, or the one that holds for all.
std::span<const ModelChoice> contact_sets(const Models& models);

}  // namespace similitude
