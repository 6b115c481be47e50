#pragma once
/// What the gas and the solids do at a few places, written with every row of monitors.csv: what a pressure tap sees.

#include <vector>

#include "coupling/coupling.h"
#include "fluid/grid.h"
#include "output/csv.h"
#include "output/directory.h"
#include "output/map_back.h"
#include "scene/scene.h"

namespace similitude {

inline constexpr const char* k_probes_file = "probes.csv";

/// Of the real bed, at one place. The cell that the place lies in speaks for it; nothing is interpolated across a plate.
struct ProbeReading {
  double pressure = 0;                     // [Pa], above rho_f g.x
  std::array<double, 3> gas_velocity{};    // [m/s], interstitial
  double gas_fraction = 0;                 // [-]
};

/// The cell of a place [m]; a place on a face belongs to the cell above, on the domain's upper end to the last cell.
std::size_t cell_at(const Grid& grid, const std::array<double, 3>& place);

/// probes.csv; every column is named with its unit.
class ProbeFile {
 public:
  /// `probes` of the simulated bed.
  ProbeFile(const OutputDirectory& directory, const std::vector<Probe>& probes, const Grid& grid, const MapBack& map_back);
  /// Goes on after the first `length` bytes.
  ProbeFile(const OutputDirectory& directory, const std::vector<Probe>& probes, const Grid& grid, const MapBack& map_back,
            std::uint64_t length);

  /// A row per probe. Time [s] is the simulated bed's.
  void write(double time, const GasFields& gas, const Column<double>& gas_fraction);
  std::uint64_t length() const { return csv_.length(); }   // [bytes], whole rows only

 private:
  struct Tap {
    Probe probe;
    std::size_t cell;
  };
  static std::vector<Tap> taps(const std::vector<Probe>& probes, const Grid& grid);

  std::vector<Tap> taps_;
  MapBack map_back_;
  CsvWriter csv_;
};

ProbeReading read_probe(std::size_t cell, const GasFields& gas, const Column<double>& gas_fraction, const MapBack& map_back);

}  // namespace similitude
