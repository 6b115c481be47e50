#include "particles/settle.h"

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <numbers>

#include <similitude/sphere.h>

#include "particles/engine.h"
#include "particles/errors.h"
#include "particles/impacts.h"

namespace similitude {

namespace {

constexpr double k_at_rest = 2e-4;              // [-], agitation of a resting bed
constexpr double k_soft_overlap = 0.004;        // [-], of a diameter, at the bottom of the softened bed
// [-], solids fraction by which the bed's layers are counted, between the loosest and the closest random packing of spheres (0.55, 0.64).
// The softness of every settled bed follows from it, and with it their last bits: it is not k_settled_packing of a bed as described.
constexpr double k_packing_of_layers = 0.6;
constexpr double k_steps_per_contact = 15;      // while settling
constexpr double k_worth_softening = 0.7;       // [-], a stiffness factor above it saves no time
constexpr double k_stiffer_per_rung = 8;        // [-], about, on the way back to the case's stiffness
constexpr double k_listening_times = 20;       // [-], contact times before a calm bed is believed
constexpr std::int64_t k_steps_between_looks = 50;
constexpr std::int64_t k_most_steps = 1000000;  // of one phase; a bed takes some thousand

double magnitude(const std::array<double, 3>& g) { return std::sqrt(g[0] * g[0] + g[1] * g[1] + g[2] * g[2]); }

/// What sets the pace of settling: the lightest class, which materials meet, and how high the bed is in diameters.
struct Scale {
  Scale(const ParticleStore& particles, const ModelScene& scene) : gravity(magnitude(scene.gravity)) {
    double volume = 0;
    std::size_t smallest = 0;
    classes.resize(scene.particles.size());
    for (std::size_t p = 0; p < particles.size(); ++p) {
      const double r = particles.position[p].w;
      volume += sphere_volume(2 * r);
      if (particles.velocity[p].w < particles.velocity[smallest].w) smallest = p;
      if (particles.species[p] >= classes.size()) classes.resize(particles.species[p] + 1);
      classes[particles.species[p]] = {particles.velocity[p].w, r};
    }
    mass = particles.velocity[smallest].w;
    diameter = 2 * particles.position[smallest].w;
    const double height = volume / (k_packing_of_layers * scene.size[0] * scene.size[1]);
    layers = std::max(1.0, height / diameter);
  }
  /// Of the quickest pair of materials.
  double contact_time(const ContactModel& law) const {
    double least = HUGE_VAL;
    for (const Impact& impact : possible_impacts(classes, law)) least = std::min(least, impact.contact_time(law, impact_speed()));
    return least;
  }
  double largest_stable_step(const ContactModel& law) const {
    double least = HUGE_VAL;
    for (const Impact& impact : possible_impacts(classes, law))
      least = std::min(least, impact.largest_stable_step(law, impact_speed()));
    return least;
  }
  /// Of the lightest class, were all its contacts those of the softest pair of materials.
  double longest_contact_time(const ContactModel& law) const {
    double longest = 0;
    for (Impact impact : possible_impacts(classes, law)) {
      impact.effective_mass = mass / 2;
      impact.effective_radius = diameter / 4;
      longest = std::max(longest, impact.contact_time(law, impact_speed()));
    }
    return longest;
  }
  double impact_speed() const { return std::sqrt(2 * gravity * diameter); }

  double gravity;    // [m/s^2]
  double mass;       // [kg]
  double diameter;   // [m]
  double layers;     // [-]
  std::vector<Sphere> classes;
};

/// A stretch of settling with one law and one step.
struct Phase {
  const char* stage;   // for the progress line
  double dt;           // [s]
  double damping;      // [1/s], of velocities
  double least;        // [s], its shortest duration
  double calm;         // [-], agitation at which it ends
  double from, to;     // [-], of the whole progress
};

class Settling {
 public:
  Settling(ParticleStore& particles, const ModelScene& scene, const FillOptions& options)
      : particles_(particles), scene_(scene), options_(options), scale_(particles, scene) {
    scene_.patches.clear();   // nothing leaves while it settles
  }

  /// The stiffness factor at which the bed's own weight presses the lowest particles together by k_soft_overlap, where the
  /// softest pair of materials meets.
  double softness(const ContactModel& law) const {
    const double stiffness = scale_.layers * scale_.mass * scale_.gravity / (k_soft_overlap * scale_.diameter);
    const double slow = std::numbers::pi * std::sqrt(scale_.mass / 2 / stiffness);   // [s], contact time of that spring
    const double ratio = scale_.longest_contact_time(law) / slow;
    return ratio * ratio;
  }

  /// Advances until the bed is calm, but for `least` [s] at least.
  void until_calm(const ContactModel& law, const Phase& phase) {
    Engine engine(particles_, scene_, law,
                  EngineOptions{.dt = phase.dt, .gravity = scene_.gravity, .skin = 0, .velocity_damping = phase.damping});
    double wildest = 0;
    for (std::int64_t steps = 0; steps < k_most_steps;) {
      engine.advance(k_steps_between_looks);
      steps += k_steps_between_looks;
      sub_steps_ += k_steps_between_looks;
      const double now = agitation(particles_, scene_);
      wildest = std::max(wildest, now);
      if (options_.progress) {
        const double done = wildest > phase.calm ? std::log(wildest / now) / std::log(wildest / phase.calm) : 1;
        options_.progress(phase.from + (phase.to - phase.from) * std::clamp(done, 0.0, 1.0), phase.stage);
      }
      if (now < phase.calm && static_cast<double>(steps) * phase.dt >= phase.least) return;
    }
    char text[240];
    std::snprintf(text, sizeof text,
                  "the bed did not come to rest while filling: after %lld sub-steps of %.3g s the mean kinetic energy of a particle "
                  "is %.3g m g d; a bed rests below %.3g.",
                  static_cast<long long>(k_most_steps), phase.dt, agitation(particles_, scene_), phase.calm);
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
  const Scale& scale = settling.scale();
  const double softness = settling.softness(law);
  const bool soften = options.softer_law && softness < k_worth_softening;
  const ContactModel softened = soften ? options.softer_law(softness) : ContactModel();
  const ContactModel& soft = soften ? softened : law;
  const auto step = [&](const ContactModel& spring) {
    return std::min(scale.contact_time(spring) / k_steps_per_contact, scale.largest_stable_step(spring) / 2);
  };
  const auto listening = [&](const ContactModel& spring) { return k_listening_times * scale.longest_contact_time(spring); };

  // Neighbours part without flying: their motion is overdamped. Then the bed falls the little way to its packing, braked at
  // the pace of a fall by one diameter: less and it bounces, more and it sinks like honey.
  const double overdamped = 10 * std::numbers::pi / scale.contact_time(soft);   // [1/s]
  const double braked = std::sqrt(scale.gravity / scale.diameter);              // [1/s]
  settling.until_calm(soft, {"parting neighbours", step(soft), overdamped, listening(soft), HUGE_VAL, 0, 0.1});
  settling.until_calm(soft, {"settling", step(soft), braked, listening(soft), k_at_rest / 2, 0.1, 0.6});
  stop(particles);
  // Stiffer springs release what softer ones stored: rung by rung, while steps are still long.
  const int rungs = soften ? std::max(1, static_cast<int>(std::lround(-std::log(softness) / std::log(k_stiffer_per_rung)))) : 1;
  for (int rung = 1; rung < rungs; ++rung) {
    const ContactModel stiffer = options.softer_law(std::pow(softness, 1 - static_cast<double>(rung) / rungs));
    settling.until_calm(stiffer, {"stiffening", step(stiffer), braked, listening(stiffer), k_at_rest, 0.6, 0.7});
    stop(particles);
  }
  settling.until_calm(law, {"changing to the case's stiffness", options.dt, braked, listening(law), k_at_rest, 0.7, 0.9});
  stop(particles);
  // At last nothing but the law itself holds the bed.
  settling.until_calm(law, {"coming to rest", options.dt, 0, listening(law), k_at_rest, 0.9, 1});
  stop(particles);
  return settling.sub_steps();
}

}  // namespace similitude
