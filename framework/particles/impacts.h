#pragma once
/// Which impacts a bed can see: what a contact law is asked about before its time step is chosen.

#include <cstdint>
#include <vector>

#include "loader/catalogue.h"
#include "loader/contact_answers.h"
#include "scene/material_pairs.h"

namespace similitude {

struct Sphere {
  double mass = 0;     // [kg]; 0: there is none of this class
  double radius = 0;   // [m]
};

/// Two spheres, or a sphere and a wall, of two materials.
struct Impact {
  MaterialPair materials;
  std::uint32_t set = 0;         // of the law's parameters
  double effective_mass = 0;     // [kg]
  double effective_radius = 0;   // [m]

  /// As contact_answers.h, with its errors.
  double contact_time(const ContactModel& law, double speed) const {   // [s]
    return contact_time_of(law, {set, effective_mass, effective_radius, speed});
  }
  double largest_stable_step(const ContactModel& law, double speed) const {   // [s]
    return largest_stable_step_of(law, {set, effective_mass, effective_radius, speed});
  }
};

/// Every pair of classes that are there, then every class with the wall; a sphere for each class of the scene.
inline std::vector<Impact> possible_impacts(const std::vector<Sphere>& classes, const ContactModel& law) {
  const auto there = [&](std::size_t material) { return material == classes.size() || classes[material].mass > 0; };
  const std::vector<MaterialPair> pairs = material_pairs(classes.size());
  std::vector<Impact> impacts;
  for (std::size_t p = 0; p < pairs.size(); ++p) {
    const MaterialPair& pair = pairs[p];
    if (!there(pair.first) || !there(pair.second)) continue;
    const Sphere& one = classes[pair.first];
    Impact impact{pair, law.sets() > 1 ? static_cast<std::uint32_t>(p) : 0, one.mass, one.radius};
    if (pair.first == pair.second) {
      impact.effective_mass = one.mass / 2;
      impact.effective_radius = one.radius / 2;
    } else if (pair.second < classes.size()) {
      const Sphere& other = classes[pair.second];
      impact.effective_mass = one.mass * other.mass / (one.mass + other.mass);
      impact.effective_radius = one.radius * other.radius / (one.radius + other.radius);
    }
    impacts.push_back(impact);
  }
  return impacts;
}

}  // namespace similitude
