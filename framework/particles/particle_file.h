#pragma once
/// Beds that come from a file: CSV, VTP (VTK XML PolyData) or LAMMPS data. Lengths, speeds and densities are the real bed's, SI.

#include <array>
#include <optional>
#include <string>
#include <vector>

namespace similitude {

struct FileParticle {
  std::array<double, 3> position{};   // [m]
  std::array<double, 3> velocity{};   // [m/s], zero where the file has none
  std::optional<double> diameter;     // [m]
  std::optional<double> density;      // [kg/m^3]
  std::optional<int> type;            // LAMMPS atom type, from 1
  int line = 0;                       // of the file, from 1; 0: not a text file
};

/// The kind follows from the name: .csv, .vtp, or .data, .lmp and .lammps for LAMMPS data.
/// CSV: a header with x, y, z and any of vx, vy, vz, diameter or radius, density; names may carry their unit, "x [m]".
/// VTP: points, with point arrays velocity, diameter or radius, density; names may carry their unit.
/// LAMMPS data: section Atoms of atom_style sphere (id type diameter density x y z), Velocities if there.
/// Throws InputError naming file, line and what was expected.
std::vector<FileParticle> read_particle_file(const std::string& file);

/// One reader per kind, for read_particle_file.
std::vector<FileParticle> read_csv_particles(const std::string& file);
std::vector<FileParticle> read_vtp_particles(const std::string& file);
std::vector<FileParticle> read_lammps_particles(const std::string& file);

}  // namespace similitude
