#include "doctor/contact_impact.h"

#include <similitude/restitution.h>

#include <algorithm>
#include <cmath>

#include "doctor/trial_values.h"

namespace similitude::doctor {
namespace {

/// The sphere i moves along -x and perhaps y toward the partner j, which rests at the origin.
struct Bodies {
  double mass_i, mass_j, radius_i, radius_j;   // [kg], [m]; infinite: a wall, whose face is x = 0
  Vector offset{0, 0, 0};                      // [m], i's centre from j's, or from the wall's
  Vector velocity_i, velocity_j{0, 0, 0};
  Vector spin_i{0, 0, 0}, spin_j{0, 0, 0};
  bool touched = false, parted = false;

  bool wall() const { return std::isinf(radius_j); }
  double inertia_i() const { return 0.4 * mass_i * radius_i * radius_i; }
  double inertia_j() const { return 0.4 * mass_j * radius_j * radius_j; }
  double energy() const {   // [J]
    double e = 0.5 * mass_i * dot(velocity_i, velocity_i) + 0.5 * inertia_i() * dot(spin_i, spin_i);
    if (!wall()) e += 0.5 * mass_j * dot(velocity_j, velocity_j) + 0.5 * inertia_j() * dot(spin_j, spin_j);
    return e;
  }
  double distance() const { return wall() ? offset.x : std::sqrt(dot(offset, offset)); }
  double overlap() const { return radius_i + (wall() ? 0 : radius_j) - distance(); }
  Vector normal() const { return wall() ? Vector{1, 0, 0} : (1 / distance()) * offset; }
  /// Levers sum to the distance; the contact lies in the middle of the overlap's lens, nearly.
  double lever_i() const { return wall() ? distance() : distance() * radius_i / (radius_i + radius_j); }
  double lever_j() const { return wall() ? 0 : distance() - lever_i(); }
};

Bodies bodies_of(const ImpactStart& start, double reach) {
  Bodies b{};
  b.radius_i = trial_bed().particle_diameter / 2;
  b.mass_i = sphere_mass();
  b.radius_j = start.radius_ratio * b.radius_i;
  b.mass_j = std::pow(start.radius_ratio, 3) * b.mass_i;
  b.offset = {b.radius_i + (b.wall() ? 0 : b.radius_j) + reach, 0, 0};
  b.velocity_i = {-start.speed * std::cos(start.angle), start.speed * std::sin(start.angle), 0};
  b.velocity_j = {0, 0, 0};
  b.spin_i = {0, 0, start.spin * start.speed / b.radius_i};
  return b;
}

ContactRow row_of(const Bodies& b, const ImpactStart& start, bool rotates) {
  ContactRow c;
  c.normal = b.normal();
  c.overlap = b.overlap();
  c.velocity = b.velocity_i - b.velocity_j;
  if (rotates) {
    c.velocity = c.velocity + cross(b.spin_i, -b.lever_i() * c.normal) - cross(b.spin_j, b.lever_j() * c.normal);
    c.spin_i = b.spin_i;
    c.spin_j = b.spin_j;
  }
  c.radius_i = b.radius_i;
  c.radius_j = b.radius_j;
  c.effective_mass = effective_mass(start);
  return c;
}

void push(Bodies& b, const ContactAnswer& answer, const Vector& normal, double dt, bool rotates) {
  b.velocity_i = b.velocity_i + (dt / b.mass_i) * answer.force;
  if (!b.wall()) b.velocity_j = b.velocity_j - (dt / b.mass_j) * answer.force;
  if (!rotates) return;
  b.spin_i = b.spin_i + (dt / b.inertia_i()) * (cross(-b.lever_i() * normal, answer.force) + answer.couple);
  if (!b.wall()) b.spin_j = b.spin_j - (dt / b.inertia_j()) * (cross(b.lever_j() * normal, answer.force) + answer.couple);
}

}  // namespace

double sphere_mass() {
  const similitude_bed bed = trial_bed();
  return bed.particle_density * k_pi / 6 * std::pow(bed.particle_diameter, 3);
}

double effective_mass(const ImpactStart& start) {
  if (std::isinf(start.radius_ratio)) return sphere_mass();
  const double partner = std::pow(start.radius_ratio, 3) * sphere_mass();
  return sphere_mass() * partner / (sphere_mass() + partner);
}

double effective_radius(const ImpactStart& start) {
  const double radius = trial_bed().particle_diameter / 2;
  return std::isinf(start.radius_ratio) ? radius : radius * start.radius_ratio / (1 + start.radius_ratio);
}

double told_contact_time(const ContactModel& law, const ImpactStart& start) {
  return law.functions().contact_time(law.instance(), 0, effective_mass(start), effective_radius(start), start.speed);
}

double told_stable_step(const ContactModel& law, const ImpactStart& start) {
  return law.functions().largest_stable_step(law.instance(), 0, effective_mass(start), effective_radius(start), start.speed);
}

std::vector<ImpactEnd> play(const ContactModel& law, const std::vector<ImpactStart>& starts, double dt, double longest) {
  const double reach = reach_of(law, trial_bed().particle_diameter);
  ContactBlock block(law, starts.size());
  const bool rotates = block.needs().rotation != 0;
  std::vector<Bodies> bodies;
  std::vector<ImpactEnd> ends(starts.size());
  std::vector<double> energy_before;
  for (const ImpactStart& start : starts) {
    bodies.push_back(bodies_of(start, reach));
    energy_before.push_back(bodies.back().energy());
  }
  for (double time = 0; time < longest; time += dt) {
    bool all_parted = true;
    for (std::size_t n = 0; n < bodies.size(); ++n) {
      Bodies& b = bodies[n];
      ContactRow row = row_of(b, starts[n], rotates);
      if (row.overlap > -reach) b.touched = true;
      if (row.overlap <= -reach) {
        b.parted = b.touched;
        block.forget(n);
      }
      all_parted = all_parted && b.parted;
      row.overlap = std::max(row.overlap, -reach);   // a law is not asked about partners out of its reach
      block.set(n, row);
    }
    if (all_parted) break;
    block.advance(dt);
    for (std::size_t n = 0; n < bodies.size(); ++n) {
      Bodies& b = bodies[n];
      if (b.parted) continue;
      const Vector normal = b.normal();
      const double overlap = b.overlap();
      if (overlap > -reach) {
        const ContactAnswer answer = block.answer(n);
        push(b, answer, normal, dt, rotates);
        if (dot(answer.force, normal) > 0) ends[n].force_time += dt;
        if (overlap > 0) ends[n].overlap_time += dt;
        ends[n].deepest = std::max(ends[n].deepest, overlap);
      }
      b.offset = b.offset + dt * (b.velocity_i - b.velocity_j);
    }
  }
  for (std::size_t n = 0; n < bodies.size(); ++n) {
    const Bodies& b = bodies[n];
    ends[n].parted = b.parted;
    ends[n].energy_ratio = b.energy() / energy_before[n];
    ends[n].restitution = dot(b.velocity_i - b.velocity_j, b.normal()) / (starts[n].speed * std::cos(starts[n].angle));
  }
  return ends;
}

}  // namespace similitude::doctor
