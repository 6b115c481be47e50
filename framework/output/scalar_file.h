#pragma once
/// scalars.csv: what gas and particles hold of every scalar that effects carry, and where it came from; a row per scalar with
/// every row of monitors.csv.

#include <string>

#include "output/csv.h"
#include "output/directory.h"

namespace similitude {

inline constexpr const char* k_scalars_file = "scalars.csv";

/// One scalar of the gas or of the particles, of the real bed. Amounts (J, kg) since the start and counted from the values there;
/// NaN: it has no such thing.
struct ScalarReading {
  std::string name, unit, carrier, amount_unit;   // carrier: "gas" or "particles"
  double mean = 0, lowest = 0, highest = 0;        // by gas volume, by mass of particles
  double amount = 0;                               // gained since the start
  double in = 0, out = 0, walls = 0;               // through patches; from walls
  double exchanged = 0;                            // from the particles into the gas
};

class ScalarFile {
 public:
  explicit ScalarFile(const OutputDirectory& directory);
  /// Goes on after the first `length` bytes.
  ScalarFile(const OutputDirectory& directory, std::uint64_t length);
  /// `time` [s] of the real bed.
  void write(double time, const ScalarReading& reading);
  std::uint64_t length() const { return csv_.length(); }

 private:
  CsvWriter csv_;
};

}  // namespace similitude
