#include "particles/settle.h"

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <numbers>

#include "particles/engine.h"
#include "particles/errors.h"

namespace similitude {

namespace {

constexpr double k_at_rest = 2e-4;               // [-], agitation of a resting bed
constexpr double k_soft_overlap = 0.005;         // [-], of a diameter, at the bottom of the softened bed
constexpr double k_steps_per_contact = 15;       // while settling
constexpr double k_worth_softening = 0.7;        // [-], a stiffness factor above it saves no time
constexpr int k_steps_between_looks = 50;
constexpr std::int64_t k_most_steps = 1000000;   // of one stage; a bed takes some thousand

double magnitude(const std::array<double, 3>& g) { return std::sqrt(g[0] * g[0] + g[1] * g[1] + g[2] * g[2]); }

/// What sets the pace of settling: the lightest class, and how high the bed is in diameters.
struct Scale {
  Scale(const ParticleStore& particles, const ModelScene& scene) : gravity(magnitude(scene.gravity)) {
    double volume = 0;
    std::size_t smallest = 0;
    for (std::size_t p = 0; p < particles.size(); ++p) {
      const double r = particles.position[p].w;
      volume += 4.0 / 3 * std::numbers::pi * (r * r * r);
      if (particles.velocity[p].w < particles.velocity[smallest].w) smallest = p;
    }
    mass = particles.velocity[smallest].w;
    diameter = 2 * particles.position[smallest].w;
    const double height = volume / (0.6 * scene.size[0] * scene.size[1]);
    layers = std::max(1.0, height / diameter);
  }
  double contact_time(const ContactModel& law) const {
    return law.functions().contact_time(law.instance(), 0, mass / 2, diameter / 4, impact_speed());
  }
  double largest_stable_step(const ContactModel& law) const {
    return law.functions().largest_stable_step(law.instance(), 0, mass / 2, diameter / 4, impact_speed());
  }
  double impact_speed() const { return std::sqrt(2 * gravity * diameter); }

  double gravity;    // [m/s^2]
  double mass;       // [kg]
  double diameter;   // [m]
  double layers;     // [-]
};

class Settling {
 public:
  Settling(ParticleStore& particles, const ModelScene& scene, const FillOptions& options)
      : particles_(particles), scene_(scene), options_(options), scale_(particles, scene) {
    scene_.patches.clear();   // nothing leaves while it settles
  }

  /// The stiffness factor at which the bed's own weight presses the lowest particles together by k_soft_overlap.
  double softness(const ContactModel& law) const {
    const double stiffness = scale_.layers * scale_.mass * scale_.gravity / (k_soft_overlap * scale_.diameter);
    const double slow = std::numbers::pi * std::sqrt(scale_.mass / 2 / stiffness);   // [s], contact time of that spring
    const double ratio = scale_.contact_time(law) / slow;
    return ratio * ratio;
  }

  void until_at_rest(const ContactModel& law, double dt, const std::string& stage, double from, double to) {
    // Critical for the slowest wave through the bed, one contact time per layer and direction.
    const double damping = std::numbers::pi / (scale_.layers * scale_.contact_time(law));
    Engine engine(particles_, scene_, law,
                  EngineOptions{.dt = dt, .gravity = scene_.gravity, .skin = 0, .velocity_damping = damping});
    double highest = 0;
    for (std::int64_t steps = 0; steps < k_most_steps; steps += k_steps_between_looks) {
      engine.advance(k_steps_between_looks);
      sub_steps_ += k_steps_between_looks;
      const double now = agitation(particles_, scene_);
      highest = std::max(highest, now);
      if (options_.progress) {
        const double done = now >= highest ? 0 : std::log(highest / now) / std::log(highest / k_at_rest);
        options_.progress(from + (to - from) * std::clamp(done, 0.0, 1.0), stage);
      }
      // A bed about to fall is slow as well: the first looks do not count.
      if (now < k_at_rest && steps >= 4 * k_steps_between_looks) return;
    }
    char text[200];
    std::snprintf(text, sizeof text, "the bed did not come to rest while filling: after %lld sub-steps of %.3g s particles still "
                  "move with %.3g m g d on average.", static_cast<long long>(k_most_steps), dt, agitation(particles_, scene_));
    throw SimulationError(text, "A contact law without friction or damping may never rest: use bed: {fill: lattice}, or a file.");
  }

  std::int64_t sub_steps() const { return sub_steps_; }
  const Scale& scale() const { return scale_; }

 private:
  ParticleStore& particles_;
  ModelScene scene_;
  const FillOptions& options_;
  Scale scale_;
  std::int64_t sub_steps_ = 0;
};

void stop(ParticleStore& particles) {
  for (Row& v : particles.velocity) v = {0, 0, 0, v.w};
  for (Row& w : particles.angular_velocity) w = {0, 0, 0, w.w};
}

}  // namespace

double agitation(const ParticleStore& particles, const ModelScene& scene) {
  double kinetic = 0, lift = 0;   // [J]
  const double gravity = magnitude(scene.gravity);
  for (std::size_t p = 0; p < particles.size(); ++p) {
    const Row& v = particles.velocity[p];
    kinetic += 0.5 * v.w * (v.x * v.x + v.y * v.y + v.z * v.z);
    lift += v.w * gravity * 2 * particles.position[p].w;
  }
  return kinetic / lift;
}

std::int64_t settle(ParticleStore& particles, const ModelScene& scene, const ContactModel& law, const FillOptions& options) {
  if (particles.size() == 0) return 0;
  Settling settling(particles, scene, options);
  const double softness = settling.softness(law);
  const bool soften = options.softer_law && softness < k_worth_softening;
  const ContactModel soft = soften ? options.softer_law(softness) : ContactModel();
  const ContactModel& first = soften ? soft : law;
  const double dt = std::min(settling.scale().contact_time(first) / k_steps_per_contact,
                             settling.scale().largest_stable_step(first) / 2);
  settling.until_at_rest(first, dt, "settling", 0, 0.8);
  stop(particles);
  settling.until_at_rest(law, options.dt, "coming to rest", 0.8, 1);
  stop(particles);
  return settling.sub_steps();
}

}  // namespace similitude
