#pragma once
/// A few spheres in a box, moved by the particle engine under a shipped contact law; and tables of other people's numbers.

#include <array>
#include <fstream>
#include <limits>
#include <map>
#include <memory>
#include <sstream>
#include <stdexcept>
#include <string>
#include <vector>

#include "particles/engine.h"

namespace similitude::test {

constexpr double k_pi = 3.14159265358979323846;

/// Parameters by name; what is left out takes its default.
using Values = std::map<std::string, double>;

inline ContactModel make_law(const std::string& file, const Values& given) {
  static std::map<std::string, Catalogue> opened;
  const auto found = opened.find(file);
  const Catalogue& catalogue = found != opened.end() ? found->second : opened.emplace(file, Catalogue::of_file(file)).first->second;
  const PluginEntry& plugin = catalogue.plugins().at(0);
  std::vector<similitude_value> values;
  for (std::uint32_t p = 0; p < plugin.descriptor->parameter_count; ++p) {
    const similitude_parameter& parameter = plugin.descriptor->parameters[p];
    const auto it = given.find(parameter.name);
    values.push_back({it == given.end() ? parameter.default_value : it->second, nullptr});
  }
  similitude_bed bed{};
  bed.struct_size = sizeof bed;
  return create_model<similitude_contact_functions>(plugin, bed, values);
}

struct Sphere {
  double radius, density;   // [m], [kg/m^3]
  double mass() const { return 4.0 / 3 * k_pi * radius * radius * radius * density; }
};

class Spheres {
 public:
  Spheres(const std::string& law_file, const Values& values, std::array<double, 3> size, double gravity = 0)
      : law_(make_law(law_file, values)), store_({.rotation = true, .coupling = false}) {
    scene_.size = size;
    options_.gravity = {0, 0, -gravity};
  }

  void add(const Sphere& sphere, std::array<double, 3> place, std::array<double, 3> velocity = {}, std::array<double, 3> spin = {}) {
    const std::size_t row = store_.add(store_.size(), 0, place[0], place[1], place[2], sphere.radius, sphere.mass());
    store_.velocity[row] = {velocity[0], velocity[1], velocity[2], sphere.mass()};
    store_.angular_velocity[row] = {spin[0], spin[1], spin[2], 0.4 * sphere.mass() * sphere.radius * sphere.radius};
  }

  void make_periodic() { scene_.periodic = {true, true, true}; }   // before the first step

  void advance(double dt, std::int64_t steps = 1) {
    if (!engine_) {
      options_.dt = dt;
      engine_ = std::make_unique<Engine>(store_, scene_, law_, options_);
    }
    engine_->advance(steps);
  }

  /// [s], of a head-on impact.
  double contact_time(double effective_mass, double effective_radius, double speed) const {
    return law_.functions().contact_time(law_.instance(), 0, effective_mass, effective_radius, speed);
  }

  const Row& position(std::uint64_t id) const { return store_.position[row_of(id)]; }
  const Row& velocity(std::uint64_t id) const { return store_.velocity[row_of(id)]; }
  const Row& spin(std::uint64_t id) const { return store_.angular_velocity[row_of(id)]; }
  const Row& force(std::uint64_t id) const { return store_.force[row_of(id)]; }   // at the start of the last step
  bool touching() const { return engine_ && engine_->report().contacts > 0; }     // then, too

 private:
  std::size_t row_of(std::uint64_t id) const {
    for (std::size_t row = 0; row < store_.size(); ++row) {
      if (store_.id[row] == id) return row;
    }
    throw std::logic_error("no such sphere");
  }

  ContactModel law_;
  ModelScene scene_;
  ParticleStore store_;
  EngineOptions options_;
  std::unique_ptr<Engine> engine_;
};

/// The rows of numbers of a file, a block per gap of other text between them.
using Block = std::vector<std::vector<double>>;
inline std::vector<Block> read_blocks(const std::string& name) {
  std::ifstream file(std::string(DEM_DATA) + "/" + name);
  if (!file) throw std::runtime_error("no data file " + name);
  std::vector<Block> blocks;
  bool inside = false;
  for (std::string line; std::getline(file, line);) {
    std::istringstream words(line);
    std::vector<double> row;
    for (double value; words >> value;) row.push_back(value);
    const bool numbers = words.eof() && row.size() >= 2;
    if (numbers && !inside) blocks.emplace_back();
    if (numbers) blocks.back().push_back(row);
    inside = numbers;
  }
  return blocks;
}

}  // namespace similitude::test
