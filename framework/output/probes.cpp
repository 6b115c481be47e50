#include "output/probes.h"

#include <algorithm>

namespace similitude {
namespace {

const std::vector<std::string> k_columns{"time [s]",
                                         "probe",
                                         "x [m]",
                                         "y [m]",
                                         "z [m]",
                                         "pressure [Pa]",
                                         "gas_velocity_x [m/s]",
                                         "gas_velocity_y [m/s]",
                                         "gas_velocity_z [m/s]",
                                         "gas_fraction [1]"};

}  // namespace

std::size_t cell_at(const Grid& grid, const std::array<double, 3>& place) {
  std::array<int, 3> at{};
  for (int axis = 0; axis < 3; ++axis) {
    const auto a = static_cast<std::size_t>(axis);
    at[a] = std::clamp(static_cast<int>(place[a] / grid.spacing(axis)), 0, grid.cells(axis) - 1);
  }
  return grid.cell(at[0], at[1], at[2]);
}

ProbeReading read_probe(std::size_t cell, const GasFields& gas, const Column<double>& gas_fraction, const MapBack& map) {
  const std::size_t cells = gas.pressure.size();
  ProbeReading reading;
  reading.pressure = map.pressure(gas.pressure[cell]);
  for (std::size_t axis = 0; axis < 3; ++axis) reading.gas_velocity[axis] = map.velocity(gas.velocity[axis * cells + cell]);
  reading.gas_fraction = gas_fraction[cell];
  return reading;
}

ProbeFile::ProbeFile(const OutputDirectory& directory, const std::vector<Probe>& probes, const Grid& grid, const MapBack& map_back)
    : taps_(taps(probes, grid)), map_back_(map_back), csv_(directory.file(k_probes_file), k_columns) {}

ProbeFile::ProbeFile(const OutputDirectory& directory, const std::vector<Probe>& probes, const Grid& grid, const MapBack& map_back,
                     std::uint64_t length)
    : taps_(taps(probes, grid)), map_back_(map_back), csv_(directory.file(k_probes_file), k_columns, length) {}

std::vector<ProbeFile::Tap> ProbeFile::taps(const std::vector<Probe>& probes, const Grid& grid) {
  std::vector<Tap> taps;
  for (const Probe& probe : probes) taps.push_back({probe, cell_at(grid, probe.place)});
  return taps;
}

void ProbeFile::write(double time, const GasFields& gas, const Column<double>& gas_fraction) {
  for (const Tap& tap : taps_) {
    const ProbeReading reading = read_probe(tap.cell, gas, gas_fraction, map_back_);
    std::vector<std::string> fields{csv_number(map_back_.time(time)), csv_field(tap.probe.name)};
    for (const double x : tap.probe.place) fields.push_back(csv_number(map_back_.length(x)));
    fields.push_back(csv_number(reading.pressure));
    for (const double u : reading.gas_velocity) fields.push_back(csv_number(u));
    fields.push_back(csv_number(reading.gas_fraction));
    csv_.row_of_text(fields);
  }
}

}  // namespace similitude
