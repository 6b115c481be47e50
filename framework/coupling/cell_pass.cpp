#include "coupling/cell_pass.h"

#include <algorithm>
#include <cmath>

#include "coupling/block_failure.h"
#include "fluid/velocity_gradient.h"

namespace similitude {
namespace {

constexpr std::size_t k_rows = 128;
static_assert(k_rows % SIMILITUDE_ROW_MULTIPLE == 0);

/// Columns of one block of cells.
struct alignas(64) CellColumns {
  using Numbers = double[k_rows];
  alignas(64) Numbers fraction, density, viscosity, strain_rate, size, added;
};

}  // namespace

void CellPass::apply(GasFields& gas, const Column<double>& gas_fraction, double time) const {
  const Staggered mesh(grid_.table());
  const auto cells = static_cast<std::size_t>(mesh.cell_count);
  const double size = std::cbrt(mesh.cell_volume());
  const std::size_t blocks = (cells + k_rows - 1) / k_rows;
  BlockFailure failure;
#pragma omp parallel for schedule(static)
  for (std::ptrdiff_t b = 0; b < static_cast<std::ptrdiff_t>(blocks); ++b) {
    CellColumns columns;
    const std::size_t first = static_cast<std::size_t>(b) * k_rows, count = std::min(k_rows, cells - first);
    const std::size_t padded = (count + SIMILITUDE_ROW_MULTIPLE - 1) / SIMILITUDE_ROW_MULTIPLE * SIMILITUDE_ROW_MULTIPLE;
    for (std::size_t n = 0; n < padded; ++n) {
      const std::size_t cell = first + std::min(n, count - 1);   // padding repeats the last cell
      const auto row = static_cast<Index>(cell);
      const Triple at{row % mesh.cells[0], row / mesh.cells[0] % mesh.cells[1], row / (mesh.cells[0] * mesh.cells[1])};
      columns.fraction[n] = gas_fraction[cell];
      columns.density[n] = scene_.gas_density;
      columns.viscosity[n] = scene_.gas_viscosity;
      columns.strain_rate[n] = strain_rate(velocity_gradient(mesh, gas.velocity.data(), at, time));
      columns.size[n] = size;
      columns.added[n] = gas.added_viscosity[cell];
    }
    const similitude_cell_block view{.struct_size = sizeof(similitude_cell_block),
                                     .rows = static_cast<std::uint32_t>(padded),
                                     .gas_fraction = columns.fraction,
                                     .gas_density = columns.density,
                                     .gas_viscosity = columns.viscosity,
                                     .strain_rate = columns.strain_rate,
                                     .cell_size = columns.size,
                                     .added_viscosity = columns.added};
    similitude_status status{};
    effect_.functions().cells(effect_.instance(), &view, &status);
    failure.tell(static_cast<std::size_t>(b), status);
    for (std::size_t n = 0; n < count; ++n) gas.added_viscosity[first + n] = columns.added[n];
  }
  if (failure) throw_failure(effect_, failure.status());
}

}  // namespace similitude
