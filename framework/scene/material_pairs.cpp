#include "scene/material_pairs.h"

#include <utility>

namespace similitude {

std::vector<MaterialPair> material_pairs(std::size_t classes) {
  std::vector<MaterialPair> pairs;
  for (std::size_t first = 0; first < classes; ++first)
    for (std::size_t second = first; second < classes; ++second) pairs.push_back({first, second});
  const std::size_t wall = classes;
  for (std::size_t first = 0; first < classes; ++first) pairs.push_back({first, wall});
  return pairs;
}

std::size_t pair_place(std::size_t classes, std::size_t one, std::size_t other) {
  if (one > other) std::swap(one, other);
  const std::size_t before = one * classes - one * (one + 1) / 2;  // pairs of the classes before, less their offsets
  if (other < classes) return before + other;
  return classes * (classes + 1) / 2 + one;
}

std::string pair_name(const std::vector<ParticleClass>& classes, const MaterialPair& pair) {
  const std::string second = pair.second < classes.size() ? classes[pair.second].name : k_wall_material;
  return classes[pair.first].name + "-" + second;
}

std::span<const ModelChoice> contact_sets(const Models& models) {
  if (models.contact_pairs.empty()) return {&models.contact, 1};
  return models.contact_pairs;
}

}  // namespace similitude
