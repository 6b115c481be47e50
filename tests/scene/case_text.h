#pragma once
/// Cases written by tests: a temporary file, and the message that reading it gives.

#include <unistd.h>

#include <filesystem>
#include <fstream>
#include <string>
#include <vector>

#include "fake_catalogue.h"
#include "scene/case_file.h"
#include "scene/messages.h"

namespace similitude::testing {

/// The example of the manual, word for word.
inline const std::string k_example = R"(similitude: 1
title: Spouted bed with draft plates, gamma-alumina
scene:
  domain:    {size: [150 mm, 20 mm, 1 m], cell: 5 mm}
  gas:       {density: 1.225 kg/m^3, viscosity: 1.79e-5 Pa s}
  particles: {alumina: {diameter: 1 mm, density: 1040 kg/m^3, count: 461000}}
  bed:       {fill: settle}
  patches:
    spout:      {face: bottom, x: [70 mm, 80 mm], velocity: 13.2 m/s}
    background: {face: bottom, rest: true, velocity: 0.46 m/s}
    outlet:     {face: top, pressure: 0 Pa}
  baffles:   {plates: {at_x: [60 mm, 90 mm], z: [30 mm, 250 mm], thickness: 2 mm}}
models:
  drag: syamlal_obrien
  contact: {id: linear_spring, stiffness: 500 N/m, restitution: 0.74, friction: 0.2}
  fluid: vans
  scaling: {id: terminal_velocity, geometry: 0.25}
  effects: auto
time:   {end: 5 s, dt: auto}
output: {vtk: every 50 ms, profiles: {z: [100 mm, 300 mm], from: 1 s}}
)";

/// A folder of this process, removed at the end.
class CaseFolder {
 public:
  CaseFolder() : path_(std::filesystem::temp_directory_path() / ("similitude-scene-" + std::to_string(::getpid()))) {
    std::filesystem::create_directories(path_);
  }
  ~CaseFolder() { std::filesystem::remove_all(path_); }
  CaseFolder(const CaseFolder&) = delete;
  CaseFolder& operator=(const CaseFolder&) = delete;
  std::filesystem::path write(const std::string& name, const std::string& text) const {
    std::ofstream(path_ / name) << text;
    return path_ / name;
  }
  const std::filesystem::path& path() const { return path_; }

 private:
  std::filesystem::path path_;
};

/// The example with one piece of its text replaced.
inline std::string example_with(const std::string& old_text, const std::string& new_text) {
  std::string text = k_example;
  const std::size_t at = text.find(old_text);
  return at == std::string::npos ? "the example has no: " + old_text : text.replace(at, old_text.size(), new_text);
}

inline CaseFile read_text_case(const std::string& text, const std::vector<std::string>& overrides = {}) {
  const CaseFolder folder;
  return read_case(folder.write("spout.yaml", text), fake_catalogue(), overrides);
}

/// What reading the case complains of, its folder taken off; "" if nothing.
inline std::string complaint(const std::string& text, const std::vector<std::string>& overrides = {}) {
  const CaseFolder folder;
  const std::filesystem::path file = folder.write("spout.yaml", text);
  std::string message;
  try {
    read_case(file, fake_catalogue(), overrides);
  } catch (const InputError& error) {
    message = error.what();
  } catch (const PluginError& error) {
    message = std::string("[plugin] ") + error.what();
  }
  const std::string prefix = folder.path().string() + "/";
  for (std::size_t at = message.find(prefix); at != std::string::npos; at = message.find(prefix))
    message.erase(at, prefix.size());
  return message;
}

}  // namespace similitude::testing
