#pragma once
/// A case written in the test itself, assembled like any other: the same reader, the same plugins, the same step.

#include <filesystem>
#include <fstream>
#include <memory>
#include <string>
#include <vector>

#include <unistd.h>

#include "scene/case_file.h"
#include "stepper/bed.h"
#include "stepper/simulation.h"

namespace similitude::test {

inline const Catalogue& built_plugins() {
  static const Catalogue catalogue(search_levels({}));
  return catalogue;
}

inline CaseFile case_of(const std::string& yaml) {
  const auto file = std::filesystem::temp_directory_path() / ("similitude_case_" + std::to_string(::getpid()) + ".yaml");
  std::ofstream(file) << yaml;
  CaseFile read = read_case(file, built_plugins());
  std::filesystem::remove(file);
  return read;
}

/// Everything a run holds, without its files.
struct SmallBed {
  std::unique_ptr<Assembly> assembly;
  TimeSteps steps;
  FilledBed filled;
  std::vector<std::string> warnings;
  std::unique_ptr<Simulation> simulation;
};

/// `particles` empty: filled as the case says.
inline std::unique_ptr<SmallBed> small_bed(const std::string& yaml, ParticleStore* particles = nullptr) {
  auto bed = std::make_unique<SmallBed>();
  bed->assembly = std::make_unique<Assembly>(assemble(case_of(yaml).scene, built_plugins()));
  bed->steps = choose_time_steps(*bed->assembly);
  StartingBed start{.particles = ParticleStore(store_fields(*bed->assembly)), .filled = {}};
  if (particles != nullptr) {
    start.particles = std::move(*particles);
  } else {
    start = fill_bed(*bed->assembly, bed->steps, {});
  }
  bed->filled = start.filled;
  SmallBed* raw = bed.get();
  bed->simulation = std::make_unique<Simulation>(*bed->assembly, bed->steps, std::move(start.particles),
                                                 [raw](const std::string& text) { raw->warnings.push_back(text); });
  return bed;
}

/// Pressure at the inlet face above the outlet's: mean of the lowest cells, carried half a cell on with the gradient there.
inline double pressure_drop(const SmallBed& bed) {
  const Grid& grid = *bed.assembly->grid;
  const auto& pressure = bed.simulation->gas().pressure;
  double lowest = 0, second = 0;
  const int nx = grid.cells(0), ny = grid.cells(1);
  for (int j = 0; j < ny; ++j) {
    for (int i = 0; i < nx; ++i) {
      lowest += pressure[grid.cell(i, j, 0)] / (nx * ny);
      second += pressure[grid.cell(i, j, 1)] / (nx * ny);
    }
  }
  return lowest + (lowest - second) / 2;
}

}  // namespace similitude::test
