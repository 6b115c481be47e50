#pragma once
/// Small beds to fill, and the law that holds them: a linear spring with friction in a few lines.

#include <stdlib.h>

#include <filesystem>
#include <fstream>
#include <stdexcept>
#include <string>
#include <vector>

#include <similitude/contact_law.h>

#include "particles/fill.h"
#include "particles/store.h"
#include "scene/scene.h"

namespace similitude::test {

/// As the shipped linear spring, friction always on.
struct Spring {
  double stiffness = 0;     // [N/m]
  double restitution = 0;   // [-]
  double friction = 0;      // [-]
  double damping = 0;       // [-]
  static constexpr HistoryValue history[] = {
      {"spring_x", "m", Parity::odd}, {"spring_y", "m", Parity::odd}, {"spring_z", "m", Parity::odd}};
  static void parameters(Parameters<Spring>& p) {
    p.real("stiffness", &Spring::stiffness, {.unit = "N/m", .min = 0, .doc = "spring"});
    p.real("restitution", &Spring::restitution, {.min = 0.01, .max = 1, .doc = "restitution"});
    p.real("friction", &Spring::friction, {.min = 0, .doc = "friction"});
  }
  void prepare() { damping = damping_ratio(restitution); }

  template <class V>
  Force<V> force(const Contact<V>& c, History<V>& history) const {
    const V resistance = 2 * damping * sqrt(stiffness * c.effective_mass);   // [kg/s]
    const V normal = stiffness * c.overlap - resistance * c.normal_velocity;
    const Vec3<V> old = history.vector(0);
    Vec3<V> spring = old - dot(old, c.normal) * c.normal + c.dt * c.tangential_velocity;
    const V tangential_stiffness = V(2.0 / 7 * stiffness);
    Vec3<V> tangential = -tangential_stiffness * spring;
    const V limit = friction * max(normal, V(0)), square = dot(tangential, tangential);
    const V kept = select(square > limit * limit, limit / sqrt(square), V(1));
    history.set_vector(0, kept * spring);
    return along(c.normal, normal) + Force<V>{kept * tangential - 0.5 * resistance * c.tangential_velocity};
  }
  double contact_time(double effective_mass, double, double) const {
    return sqrt(effective_mass / stiffness) * impact_duration(damping);
  }
  double largest_stable_step(double effective_mass, double, double) const {
    return sqrt(effective_mass / stiffness) * stable_step(damping);
  }
};

ContactModel spring_law(double stiffness, double friction = 0.2);

constexpr double k_stiffness = 100;   // [N/m]

/// 8 x 5 x 60 mm, spheres of 1 mm and 1040 kg/m^3.
inline ModelScene small_bed(std::int64_t count) {
  ModelScene scene;
  scene.size = {8e-3, 5e-3, 60e-3};
  scene.cell = {1e-3, 1e-3, 1e-3};
  ParticleClass type;
  type.name = "alumina";
  type.diameter = type.drag_diameter = type.material_diameter = 1e-3;
  type.density = 1040;
  type.count = count;
  scene.particles = {type};
  scene.bed.cache = false;
  scene.models.contact.id = "test_spring";
  scene.models.contact.parameters.resize(1);
  scene.models.contact.parameters[0].name = "stiffness";
  scene.models.contact.parameters[0].real = k_stiffness;
  return scene;
}

inline FillOptions options_for(const ModelScene& scene) {
  const ParticleClass& type = scene.particles[0];
  const double mass = type.density * 3.141592653589793 / 6 * type.diameter * type.diameter * type.diameter;
  const ContactModel law = spring_law(k_stiffness);
  FillOptions options;
  options.dt = law.functions().contact_time(law.instance(), 0, mass / 2, type.diameter / 4, 1) / 20;
  options.softer_law = [](double factor) { return spring_law(k_stiffness * factor); };
  return options;
}

inline ParticleStore empty_store() { return ParticleStore(StoreFields{.rotation = true, .coupling = true}); }

/// A folder that is gone when the test is.
class ScratchFolder {
 public:
  ScratchFolder() {
    std::string name = (std::filesystem::temp_directory_path() / "similitude-fill-XXXXXX").string();
    path_ = ::mkdtemp(name.data());
  }
  ~ScratchFolder() {
    std::error_code ignored;
    std::filesystem::remove_all(path_, ignored);
  }
  ScratchFolder(const ScratchFolder&) = delete;
  ScratchFolder& operator=(const ScratchFolder&) = delete;
  std::string write(const std::string& name, const std::string& text) const {
    const std::string file = (path_ / name).string();
    std::ofstream(file, std::ios::binary) << text;
    return file;
  }
  std::string path() const { return path_.string(); }

 private:
  std::filesystem::path path_;
};

}  // namespace similitude::test
