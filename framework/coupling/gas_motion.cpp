#include "coupling/gas_motion.h"

#include "coupling/smoothing.h"
#include "fluid/staggered.h"
#include "fluid/velocity_gradient.h"

namespace similitude {

struct GasMotion::Parts {
  Parts(const ModelScene& scene, const Grid& grid, bool coupled, unsigned reads)
      : mesh(grid.table()), map(grid), smoothing(map, coupled ? smoothing_length_of(scene) : 0),
        turns((reads & SIMILITUDE_READS_GAS_VORTICITY) != 0), accelerates((reads & SIMILITUDE_READS_GAS_ACCELERATION) != 0) {
    if (turns) vorticity.resize(map.cell_count());
    if (accelerates) {
      acceleration.resize(map.cell_count());
      before.assign(3 * map.cell_count(), 0);
    }
  }

  Staggered mesh;
  CellMap map;
  Smoothing smoothing;
  bool turns, accelerates;
  CellRows vorticity, acceleration;
  Column<double> before;   // [m/s], 3 x cells: the gas velocity at the start of the step
};

GasMotion::GasMotion(const ModelScene& scene, const Grid& grid, bool coupled, unsigned reads)
    : parts_(std::make_unique<Parts>(scene, grid, coupled, reads)) {}
GasMotion::~GasMotion() = default;

bool GasMotion::vorticity() const { return parts_->turns; }
bool GasMotion::acceleration() const { return parts_->accelerates; }
const CellRows& GasMotion::vorticity_in_cells() const { return parts_->vorticity; }
const CellRows& GasMotion::acceleration_in_cells() const { return parts_->acceleration; }

void GasMotion::remember(const GasFields& gas) {
  if (parts_->accelerates) parts_->before = gas.velocity;
}

void GasMotion::update(const GasFields& gas, double time, double dt) {
  Parts& parts = *parts_;
  const std::size_t cells = parts.map.cell_count();
  const Triple& extent = parts.mesh.cells;
  const auto update_cell = [&](const Triple& cell) {
    const auto c = static_cast<std::size_t>(parts.mesh.cell(cell));
    const VelocityGradient gradient = velocity_gradient(parts.mesh, gas.velocity.data(), cell, time);
    if (parts.turns) {
      const std::array<double, 3> curl = similitude::vorticity(gradient);
      parts.vorticity[c] = {curl[0], curl[1], curl[2], 0};
    }
    if (parts.accelerates) {
      std::array<double, 3> change{};
      for (std::size_t a = 0; a < 3; ++a) {
        change[a] = (gas.velocity[a * cells + c] - parts.before[a * cells + c]) / dt;
        for (std::size_t b = 0; b < 3; ++b) change[a] += gas.velocity[b * cells + c] * gradient[a][b];
      }
      parts.acceleration[c] = {change[0], change[1], change[2], 0};
    }
  };
#pragma omp parallel for collapse(2) schedule(static)
  for (Index k = 0; k < extent[2]; ++k) {
    for (Index j = 0; j < extent[1]; ++j) {
      for (Index i = 0; i < extent[0]; ++i) update_cell({i, j, k});
    }
  }
  if (parts.turns) parts.smoothing.apply(parts.vorticity);
  if (parts.accelerates) parts.smoothing.apply(parts.acceleration);
}

}  // namespace similitude
