#include "coupling/exchange_coefficient.h"

#include <omp.h>

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <limits>

#include <similitude/sphere.h>

#include "coupling/block_failure.h"
#include "particles/errors.h"

namespace similitude {

namespace {

std::string describe(const ParticleStore& particles, std::size_t row) {
  const Row& at = particles.position[row];
  char text[160];
  std::snprintf(text, sizeof text, "particle %llu at (%.6g, %.6g, %.6g) m", static_cast<unsigned long long>(particles.id[row]),
                at.x, at.y, at.z);
  return text;
}

}  // namespace

ExchangeCoefficient::ExchangeCoefficient(const ModelScene& scene, const CellMap& map, const DragModel& law, DragForm form)
    : map_(map), law_(law), form_(form), classes_(scene.particles), gas_density_(scene.gas_density), gas_viscosity_(scene.gas_viscosity),
      cell_size_(std::cbrt(map.cell_volume())) {
  needs_.struct_size = sizeof needs_;
  if (law.functions().needs) law.functions().needs(law.instance(), &needs_);
}

double ExchangeCoefficient::displaced_volume(const ParticleStore& particles, std::size_t p) const {
  return classes_[particles.species[p]].weight * sphere_volume(diameter_of(particles, p));
}

void ExchangeCoefficient::evaluate_block(std::size_t block, ParticleStore& particles, const CellRows& gas,
                                         const CellRows& sizes, Workspace& columns, similitude_status& status) const {
  const auto column = [&](int which) { return columns.data() + static_cast<std::size_t>(which) * k_block_rows; };
  const std::size_t first = block * k_block_rows;
  const std::size_t rows = std::min(k_block_rows, particles.size() - first);
  const std::size_t padded = (rows + SIMILITUDE_ROW_MULTIPLE - 1) / SIMILITUDE_ROW_MULTIPLE * SIMILITUDE_ROW_MULTIPLE;

  for (std::size_t n = 0; n < padded; ++n) {
    const std::size_t p = first + std::min(n, rows - 1);   // padding repeats the last particle
    const Stencil stencil = map_.stencil(particles.position[p]);
    const Row at = gather(stencil, gas);
    const Row& v = particles.velocity[p];
    const double dx = at.x - v.x, dy = at.y - v.y, dz = at.z - v.z;
    column(k_diameter)[n] = diameter_of(particles, p);
    column(k_gas_fraction)[n] = std::min(at.w, 1.0);   // weights sum to one only to rounding, and laws take sqrt(1 - eps)
    column(k_slip_speed)[n] = std::sqrt(dx * dx + dy * dy + dz * dz);
    column(k_gas_density)[n] = gas_density_;
    column(k_gas_viscosity)[n] = gas_viscosity_;
    if (needs_.sauter_diameter) {
      const Row size = gather(stencil, sizes);
      column(k_sauter)[n] = size.x / size.y;
    }
    if (needs_.cell_size) column(k_cell_size)[n] = cell_size_;
  }

  const similitude_drag_block view{.struct_size = sizeof(similitude_drag_block),
                                   .rows = static_cast<std::uint32_t>(padded),
                                   .diameter = column(k_diameter),
                                   .gas_fraction = column(k_gas_fraction),
                                   .slip_speed = column(k_slip_speed),
                                   .gas_density = column(k_gas_density),
                                   .gas_viscosity = column(k_gas_viscosity),
                                   .sauter_diameter = needs_.sauter_diameter ? column(k_sauter) : nullptr,
                                   .cell_size = needs_.cell_size ? column(k_cell_size) : nullptr,
                                   .exchange = column(k_exchange)};
  law_.functions().exchange(law_.instance(), &view, &status);
  if (status.code != 0) return;

  for (std::size_t n = 0; n < rows; ++n) {
    const std::size_t p = first + n;
    const double exchange = column(k_exchange)[n];
    if (!(exchange >= 0 && exchange <= std::numeric_limits<double>::max())) {
      status.code = 1;
      status.row = static_cast<std::int32_t>(n);
      std::snprintf(status.text, sizeof status.text, "its K is %g kg/s where the gas fraction is %g and the slip %g m/s",
                    exchange, column(k_gas_fraction)[n], column(k_slip_speed)[n]);
      return;
    }
    const double share = form_ == DragForm::over_gas_fraction ? 1 / column(k_gas_fraction)[n] : 1;
    particles.gas[p].w = classes_[particles.species[p]].weight * (share * exchange);
  }
}

void ExchangeCoefficient::evaluate(ParticleStore& particles, const CellRows& gas, const CellRows& sizes) {
  const std::size_t blocks = (particles.size() + k_block_rows - 1) / k_block_rows;
  const auto threads = static_cast<std::size_t>(omp_get_max_threads());
  while (workspaces_.size() < threads) workspaces_.emplace_back(k_columns * k_block_rows);

  BlockFailure failure;
#pragma omp parallel for schedule(dynamic, 4)
  for (std::ptrdiff_t b = 0; b < static_cast<std::ptrdiff_t>(blocks); ++b) {
    const auto block = static_cast<std::size_t>(b);
    similitude_status status{};
    status.row = -1;
    evaluate_block(block, particles, gas, sizes, workspaces_[static_cast<std::size_t>(omp_get_thread_num())], status);
    failure.tell(block, status);
  }
  if (!failure) return;
  const std::size_t row = failure.block() * k_block_rows + static_cast<std::size_t>(failure.status().row < 0 ? 0 : failure.status().row);
  throw SimulationError(std::string("the drag law \"") + law_.descriptor().id + "\" failed at " +
                            describe(particles, std::min(row, particles.size() - 1)) + ": " + failure.status().text + ".",
                        "Lengths are the simulated bed's. Is the gas step too long, or the bed denser than the law allows?");
}

}  // namespace similitude
