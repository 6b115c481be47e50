#pragma once
/// Impacts of two spheres, or of a sphere and a wall, played through with the simplest integrator there is: v += a dt, then
/// x += v dt.

#include <vector>

#include "doctor/contact_block.h"

namespace similitude::doctor {

struct ImpactStart {
  double speed = 0.5;       // [m/s], of approach
  double angle = 0;         // [rad], between velocity and normal
  double spin = 0;          // [-], of the sphere that hits: surface speed over approach speed
  double radius_ratio = 1;  // [-], of the partner's radius to the sphere's; infinite: a wall
};

struct ImpactEnd {
  bool parted = false;
  double energy_ratio = 0;      // [-], kinetic energy with spin, after over before
  double restitution = 0;       // [-], of the normal velocity
  double force_time = 0;        // [s], while the partners pushed each other
  double overlap_time = 0;      // [s], until the overlap was gone
  double deepest = 0;           // [m]
};

/// The sphere that hits has the trial bed's diameter and density.
double sphere_mass();   // [kg]
double effective_mass(const ImpactStart& start);     // [kg]
double effective_radius(const ImpactStart& start);   // [m]

/// [s], what the law tells of a head-on impact at this speed, or not a number.
double told_contact_time(const ContactModel& law, const ImpactStart& start);
double told_stable_step(const ContactModel& law, const ImpactStart& start);

/// All at once, in one block, with one step [s]; those that last longer than `longest` [s] have not parted.
std::vector<ImpactEnd> play(const ContactModel& law, const std::vector<ImpactStart>& starts, double dt, double longest);

}  // namespace similitude::doctor
