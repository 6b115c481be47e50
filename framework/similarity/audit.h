#pragma once
/// Which groups a scaling keeps, by how much it misses the others, and where that matters in this bed.

#include <optional>
#include <string>
#include <vector>

#include <similitude/abi.h>

#include "scene/scene.h"
#include "similarity/sphere_drag.h"

namespace similitude {

/// A group counts as kept within this part of its value. The similarity family misses the Stokes number by more than that,
/// by (n/r - 1) rho_f/rho_p, and the audit says so.
inline constexpr double k_kept_within = 1e-3;

struct GroupComparison {
  std::string name;      // "Fr", "u0/u_mf", …
  std::string meaning;   // "inertia over gravity"
  double exact = 0, scaled = 0;
  double ratio = 1;      // scaled / exact; 1 if the group is zero in both beds
  bool kept = true;
};

/// One bed as the audit sees it.
struct AuditedBed {
  similitude_bed bed{};
  SphereDrag drag;                 // the case's own law in this bed; empty: not asked
  double slot = 0;                 // [m], narrowest side of an inlet that does not fill its face; 0 here and below: none
  double plate_gap = 0;            // [m], clear, between plates or a plate and a wall
  double entrance = 0;             // [m], below the lowest plate
  double depth = 0;                // [m], between walls
  double cell = 0;                 // [m], smallest
  double contact_pressure = 0;     // [Pa], K/d of the first spring stiffness given, or the first elastic modulus
};

AuditedBed audited(const RealScene& scene, SphereDrag drag = {});
AuditedBed audited(const ModelScene& scene, SphereDrag drag = {});

/// The gas fraction at minimum fluidisation that the case gives: a parameter gas_fraction_at_minimum_fluidization of its
/// scaling or drag law, or what follows by Ergun from minimum_fluidization_velocity; none if neither.
std::optional<double> given_gas_fraction_at_minimum(const RealScene& scene);
/// The same, or k_gas_fraction_at_minimum if the case gives none.
double gas_fraction_at_minimum(const RealScene& scene);

/// Groups that both beds lack are left out. u_mf at `gas_fraction_at_minimum` in both.
std::vector<GroupComparison> compare_groups(const AuditedBed& real, const AuditedBed& simulated,
                                            double gas_fraction_at_minimum);
/// Only what the beds' own numbers give, as described by describe() in ratios.h.
std::vector<GroupComparison> compare_groups(const similitude_bed& real, const similitude_bed& simulated);

/// What the groups' symbols mean, with the real bed's values: "u0 = 1.309 m/s, mean superficial velocity; …". A line for the
/// speeds and lengths, then one for each group among `groups` whose name does not say how it is made.
std::vector<std::string> group_legend(const AuditedBed& real, const std::vector<GroupComparison>& groups, double gas_fraction_at_minimum);

/// What a lost group or a count of diameters means in this bed, in words with its source. Thresholds that the real bed
/// is beyond as well are not the scaling's doing and are left out.
std::vector<std::string> audit_warnings(const AuditedBed& real, const AuditedBed& simulated,
                                        const std::vector<GroupComparison>& groups);

}  // namespace similitude
