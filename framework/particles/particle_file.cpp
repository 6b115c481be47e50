#include "particles/particle_file.h"

#include <cmath>
#include <filesystem>
#include <fstream>
#include <map>

#include "particles/text_fields.h"
#include "scene/messages.h"

namespace similitude {

namespace {

constexpr std::array<const char*, 3> k_axis_names{"x", "y", "z"}, k_speed_names{"vx", "vy", "vz"};

struct Line {
  const std::string& file;
  int number;

  [[noreturn]] void refuse(const std::string& what, const std::string& fix = "") const {
    throw InputError(file + ":" + std::to_string(number) + ": " + what, fix);
  }
  double real(std::string_view word, const std::string& name) const {
    const auto value = similitude::number<double>(word);
    if (!value || !std::isfinite(*value)) refuse("expected a number for " + name + ", found \"" + std::string(word) + "\".");
    return *value;
  }
  double positive(std::string_view word, const std::string& name) const {
    const double value = real(word, name);
    if (!(value > 0)) refuse("expected a " + name + " greater than 0, found " + std::string(word) + ".");
    return value;
  }
};

std::ifstream open(const std::string& file) {
  std::ifstream in(file);
  if (!in) throw InputError("cannot read the particle file " + file + ".");
  return in;
}

/// "diameter [m]" and "Diameter" are both diameter; any other unit is refused.
std::string column_name(std::string_view title, const Line& line) {
  std::string name;
  for (const char c : title) name += static_cast<char>(c >= 'A' && c <= 'Z' ? c - 'A' + 'a' : c);
  const auto bracket = name.find('[');
  if (bracket == std::string::npos) return name;
  const std::string unit = name.substr(bracket);
  name = std::string(trimmed(std::string_view(name).substr(0, bracket)));
  const bool speed = name.front() == 'v', mass = name == "density";
  const std::string expected = speed ? "[m/s]" : mass ? "[kg/m^3]" : "[m]";
  if (unit != expected) line.refuse("column \"" + std::string(title) + "\" is read in " + expected + " only.",
                                     "Write " + name + " " + expected + ", or " + name + " alone, with values in " +
                                         (speed ? "metres per second" : mass ? "kilograms per cubic metre" : "metres") + ".");
  return name;
}

}  // namespace

std::vector<FileParticle> read_csv_particles(const std::string& file) {
  std::ifstream in = open(file);
  std::string text;
  Line line{file, 0};
  std::map<std::string, std::size_t> columns;
  std::size_t width = 0;
  std::vector<FileParticle> particles;
  while (std::getline(in, text)) {
    ++line.number;
    if (trimmed(text).empty() || trimmed(text).front() == '#') continue;
    const auto fields = comma_separated(text);
    if (width == 0) {
      width = fields.size();
      for (std::size_t n = 0; n < width; ++n) {
        if (fields[n].empty()) line.refuse("column " + std::to_string(n + 1) + " has no name.");
        columns.emplace(column_name(fields[n], line), n);
      }
      for (const char* needed : k_axis_names) {
        if (!columns.contains(needed)) {
          line.refuse(std::string("expected a header with the column ") + needed + ", found \"" + std::string(trimmed(text)) + "\".",
                      "The first line names the columns: x,y,z and any of vx,vy,vz,diameter (or radius),density.");
        }
      }
      continue;
    }
    if (fields.size() != width) {
      line.refuse("expected " + std::to_string(width) + " values as in the header, found " + std::to_string(fields.size()) + ".");
    }
    FileParticle particle;
    particle.line = line.number;
    for (std::size_t axis = 0; axis < 3; ++axis) {
      const char *place = k_axis_names[axis], *speed = k_speed_names[axis];
      particle.position[axis] = line.real(fields[columns.at(place)], place);
      if (columns.contains(speed)) particle.velocity[axis] = line.real(fields[columns.at(speed)], speed);
    }
    if (columns.contains("diameter")) particle.diameter = line.positive(fields[columns.at("diameter")], "diameter");
    else if (columns.contains("radius")) particle.diameter = 2 * line.positive(fields[columns.at("radius")], "radius");
    if (columns.contains("density")) particle.density = line.positive(fields[columns.at("density")], "density");
    particles.push_back(particle);
  }
  if (width == 0) throw InputError(file + ": expected a header x,y,z,…, but the file is empty.");
  return particles;
}

std::vector<FileParticle> read_lammps_particles(const std::string& file) {
  std::ifstream in = open(file);
  std::string text, section;
  Line line{file, 0};
  std::optional<long long> promised;   // "20000 atoms"
  std::map<long long, std::size_t> row_of;
  std::vector<FileParticle> particles;
  bool atoms_seen = false;
  while (std::getline(in, text)) {
    ++line.number;
    std::string style;
    if (const auto hash = text.find('#'); hash != std::string::npos) {
      style = std::string(trimmed(std::string_view(text).substr(hash + 1)));
      text.resize(hash);
    }
    const auto fields = words(text);
    if (line.number == 1 || fields.empty()) continue;   // LAMMPS never reads the first line
    if (!number<double>(fields[0])) {
      section = std::string(trimmed(text));
      if (section == "Atoms") {
        atoms_seen = true;
        if (!style.empty() && style != "sphere") {
          line.refuse("expected atoms of style sphere, found style " + style + ".", "Write the file with atom_style sphere.");
        }
      }
      continue;
    }
    if (section.empty()) {
      if (fields.size() == 2 && fields[1] == "atoms") promised = number<long long>(fields[0]);
      continue;
    }
    if (section == "Atoms") {
      if (fields.size() != 7 && fields.size() != 10) {
        line.refuse("expected id type diameter density x y z (and possibly three image counts), found " +
                        std::to_string(fields.size()) + " values.",
                    "Write the file with atom_style sphere.");
      }
      const auto id = number<long long>(fields[0]);
      const auto type = number<int>(fields[1]);
      if (!id || !type || *type < 1) line.refuse("expected whole numbers for id and type, the type from 1.");
      if (!row_of.emplace(*id, particles.size()).second) line.refuse("atom " + std::string(fields[0]) + " was given before.");
      FileParticle particle;
      particle.line = line.number;
      particle.type = *type;
      particle.diameter = line.positive(fields[2], "diameter");
      particle.density = line.positive(fields[3], "density");
      for (std::size_t axis = 0; axis < 3; ++axis) particle.position[axis] = line.real(fields[4 + axis], k_axis_names[axis]);
      particles.push_back(particle);
    } else if (section == "Velocities") {
      const auto id = number<long long>(fields[0]);
      if (fields.size() < 4 || !id) line.refuse("expected id vx vy vz, found " + std::to_string(fields.size()) + " values.");
      const auto row = row_of.find(*id);
      if (row == row_of.end()) line.refuse("expected the id of an atom above, found " + std::string(fields[0]) + ".");
      for (std::size_t axis = 0; axis < 3; ++axis) {
        particles[row->second].velocity[axis] = line.real(fields[1 + axis], k_speed_names[axis]);
      }
    }
  }
  if (!atoms_seen) throw InputError(file + ": expected a section Atoms, found none.", "Is this a LAMMPS data file (write_data)?");
  if (promised && *promised != static_cast<long long>(particles.size())) {
    throw InputError(file + ": the header promises " + std::to_string(*promised) + " atoms, the section Atoms has " +
                     std::to_string(particles.size()) + ".");
  }
  return particles;
}

std::vector<FileParticle> read_particle_file(const std::string& file) {
  const std::string kind = std::filesystem::path(file).extension().string();
  if (kind == ".csv") return read_csv_particles(file);
  if (kind == ".vtp") return read_vtp_particles(file);
  if (kind == ".data" || kind == ".lmp" || kind == ".lammps") return read_lammps_particles(file);
  throw InputError("particles cannot be read from " + file + ": its kind is not known by its name.",
                   "Use .csv, .vtp, or .data, .lmp or .lammps for LAMMPS data.");
}

}  // namespace similitude
