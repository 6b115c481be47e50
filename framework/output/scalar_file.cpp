#include "output/scalar_file.h"

#include <vector>

namespace similitude {
namespace {

const std::vector<std::string> k_columns{"time [s]", "scalar", "carrier", "unit",       "mean",       "lowest",         "highest",
                                         "amount_unit", "gained", "in",   "out", "from_walls", "from_particles"};

}  // namespace

ScalarFile::ScalarFile(const OutputDirectory& directory) : csv_(directory.file(k_scalars_file), k_columns) {}
ScalarFile::ScalarFile(const OutputDirectory& directory, std::uint64_t length) : csv_(directory.file(k_scalars_file), k_columns, length) {}

void ScalarFile::write(double time, const ScalarReading& r) {
  std::vector<std::string> fields{csv_number(time), csv_field(r.name), r.carrier, csv_field(r.unit)};
  for (const double value : {r.mean, r.lowest, r.highest}) fields.push_back(csv_number(value));
  fields.push_back(r.amount_unit);
  for (const double value : {r.amount, r.in, r.out, r.walls, r.exchanged}) fields.push_back(csv_number(value));
  csv_.row_of_text(fields);
}

}  // namespace similitude
