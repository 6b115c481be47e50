#pragma once
/// Folders and beds that the tests of output/ share.

#include <stdlib.h>

#include <filesystem>
#include <fstream>
#include <sstream>
#include <string>
#include <vector>

#include "output/map_back.h"
#include "particles/store.h"
#include "scene/scene.h"

namespace similitude::test {

/// A folder that is gone when the test is.
class ScratchFolder {
 public:
  ScratchFolder() {
    std::string name = (std::filesystem::temp_directory_path() / "similitude-output-XXXXXX").string();
    path_ = ::mkdtemp(name.data());
  }
  ~ScratchFolder() {
    std::error_code ignored;
    std::filesystem::remove_all(path_, ignored);
  }
  ScratchFolder(const ScratchFolder&) = delete;
  ScratchFolder& operator=(const ScratchFolder&) = delete;
  std::filesystem::path operator/(const std::string& name) const { return path_ / name; }
  const std::filesystem::path& path() const { return path_; }

 private:
  std::filesystem::path path_;
};

inline std::string text_of(const std::filesystem::path& file) {
  std::ifstream in(file, std::ios::binary);
  std::ostringstream text;
  text << in.rdbuf();
  return text.str();
}

inline std::vector<std::string> lines_of(const std::filesystem::path& file) {
  std::vector<std::string> lines;
  std::ifstream in(file);
  for (std::string line; std::getline(in, line);) lines.push_back(line);
  return lines;
}

inline std::vector<std::string> names_in(const std::filesystem::path& folder) {
  std::vector<std::string> names;
  for (const auto& entry : std::filesystem::directory_iterator(folder)) names.push_back(entry.path().filename());
  return names;
}

/// What `action` throws as Error, or "".
template <class Error, class Action>
std::string message_of(Action action) {
  try {
    action();
  } catch (const Error& error) {
    return error.what();
  }
  return "";
}

/// Froude scaling to a quarter, densities kept: v and t by 1/2. Powers of two, so that dividing by them rounds nothing.
inline MapBack quarter_scale() {
  MapBack map;
  map.ratios.length = 0.25;
  map.ratios.time = 0.5;
  map.ratios.velocity = 0.5;
  map.ratios.angular_velocity = 2;
  map.ratios.pressure = 0.25;
  map.ratios.force = 1;
  map.ratios.mass = 1.0 / 64;
  map.ratios.diameter = 0.5;
  map.scaling_law = "test_law";
  map.jet_ratio = 2;
  map.gas_density = 2;
  return map;
}

/// A bed of 80 x 60 x 160 mm (real) with an inlet over its bottom, an open top and a plate; `scale` = simulated / real.
template <class Bed>
Scene<Bed> small_bed(double scale) {
  Scene<Bed> scene;
  scene.title = "a small bed";
  scene.name = "small";
  scene.size = {0.08 * scale, 0.06 * scale, 0.16 * scale};
  scene.cell = {0.02 * scale, 0.02 * scale, 0.02 * scale};
  scene.gas_density = 1.2;
  scene.gas_viscosity = 1.8e-5;
  ParticleClass glass;
  glass.name = "glass";
  glass.diameter = glass.drag_diameter = glass.material_diameter = 1e-3;
  glass.density = 2500;
  ParticleClass alumina = glass;
  alumina.name = "alumina";
  alumina.density = 1040;
  scene.particles = {glass, alumina};

  Patch inlet;
  inlet.name = "background";
  inlet.face = {Axis::z, Side::low};
  inlet.extent = {Interval{0, scene.size[0]}, Interval{0, scene.size[1]}, Interval{0, 0}};
  inlet.velocity = 0.5;
  Patch outlet = inlet;
  outlet.name = "outlet";
  outlet.face = {Axis::z, Side::high};
  outlet.extent[2] = {scene.size[2], scene.size[2]};
  outlet.kind = PatchKind::pressure;
  outlet.pressure = 3;
  scene.patches = {inlet, outlet};

  Baffle plate;
  plate.name = "plate";
  plate.position = 0.04 * scale;
  plate.extent = {Interval{plate.position, plate.position}, Interval{0, scene.size[1]},
                  Interval{0.04 * scale, 0.1 * scale}};
  plate.thickness = 0.002 * scale;
  scene.baffles = {plate};
  return scene;
}

}  // namespace similitude::test
