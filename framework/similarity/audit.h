#pragma once
/// Which groups a scaling keeps, and by how much it misses the others.

#include <string>
#include <vector>

#include <similitude/abi.h>

namespace similitude {

/// A group counts as kept within this part of its value: the u_t law itself keeps the density-bound ones only to
/// O(rho_f/rho_p), some tenths of a per cent.
inline constexpr double k_kept_within = 5e-3;

struct GroupComparison {
  std::string name;      // "Fr", "u0/u_mf", …
  std::string meaning;   // "inertia over gravity"
  double exact = 0, scaled = 0;
  double ratio = 1;      // scaled / exact; 1 if the group is zero in both beds
  bool kept = true;
};

/// Both beds as described by describe() in ratios.h.
std::vector<GroupComparison> compare_groups(const similitude_bed& real, const similitude_bed& simulated);

}  // namespace similitude
