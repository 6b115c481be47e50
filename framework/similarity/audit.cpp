#include "similarity/audit.h"

#include <cmath>

#include "similarity/groups.h"

namespace similitude {
namespace {

struct NamedGroup {
  const char* name;
  const char* meaning;
  double Groups::*value;
};

constexpr NamedGroup k_groups[] = {
    {"Fr", "inertia over gravity", &Groups::froude},
    {"Re", "gas inertia over viscosity at a particle", &Groups::reynolds},
    {"Ar", "particle weight over viscosity", &Groups::archimedes},
    {"u0/u_mf", "gas velocity over minimum fluidisation", &Groups::over_minimum},
    {"u0/u_t", "gas velocity over terminal velocity", &Groups::over_terminal},
    {"St", "particle response time over flow time", &Groups::stokes},
    {"rho_p/rho_f", "density ratio", &Groups::density_ratio},
    {"(rho_p-rho_f)/rho_f", "buoyant density ratio", &Groups::buoyant_density_ratio},
    {"L/d", "bed width in particles", &Groups::length_ratio},
    {"J", "jet momentum over bed weight", &Groups::jet},
};

}  // namespace

std::vector<GroupComparison> compare_groups(const similitude_bed& real, const similitude_bed& simulated) {
  const Groups exact = groups(real), scaled = groups(simulated);
  std::vector<GroupComparison> comparisons;
  for (const NamedGroup& group : k_groups) {
    GroupComparison comparison{group.name, group.meaning, exact.*group.value, scaled.*group.value, 1, true};
    if (comparison.exact != 0) comparison.ratio = comparison.scaled / comparison.exact;
    comparison.kept = std::abs(comparison.ratio - 1) <= k_kept_within;
    comparisons.push_back(comparison);
  }
  return comparisons;
}

}  // namespace similitude
