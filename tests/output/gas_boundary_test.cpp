#include "output/gas_boundary.h"

#include <gmock/gmock.h>

#include "scratch.h"

using namespace similitude;
using namespace similitude::test;

namespace {

/// A box of 4 x 3 x 8 cells of 5 mm, closed but for what the test opens.
struct Box {
  ModelScene scene = small_bed<ModelBed>(0.25);
  Column<double> fraction;
  GasFields gas;

  Grid& grid() {
    if (!grid_) {
      grid_ = std::make_unique<Grid>(scene);
      gas.pressure.assign(grid_->cell_count(), 0);
      gas.velocity.assign(3 * grid_->cell_count(), 0);
      fraction.assign(grid_->cell_count(), 0.5);
    }
    return *grid_;
  }

 private:
  std::unique_ptr<Grid> grid_;
};

}  // namespace

// A pressure that falls linearly with height pushes a closed box's gas by its gradient times its volume, to rounding.
TEST(GasBoundary, CarriesALinearPressureToTheWallsExactly) {
  Box box;
  box.scene.patches.clear();
  const Grid& grid = box.grid();
  const double gradient = -1000;   // [Pa/m]
  for (int k = 0; k < grid.cells(2); ++k) {
    for (int j = 0; j < grid.cells(1); ++j) {
      for (int i = 0; i < grid.cells(0); ++i) box.gas.pressure[grid.cell(i, j, k)] = 50 + gradient * (k + 0.5) * grid.spacing(2);
    }
  }
  const BoundaryAction action = GasBoundary(grid).action(box.gas, box.fraction, 1.2, 0);
  const double volume = grid.cell_volume() * static_cast<double>(grid.cell_count());
  EXPECT_NEAR(action.force[2], -gradient * volume, 1e-12 * 1000 * volume);
  EXPECT_NEAR(action.force[0], 0, 1e-15);
  EXPECT_EQ(action.pumping, 0);
}

// The shipped small bed of these tests: an inlet and a pressure outlet. Momentum rho U^2 A and power p U A come in.
TEST(GasBoundary, CountsWhatAnInletBringsAndItsRamp) {
  Box box;
  box.scene.patches.clear();
  Patch inlet;
  inlet.name = "inlet";
  inlet.face = {Axis::z, Side::low};
  inlet.kind = PatchKind::velocity;
  inlet.velocity = 2;
  inlet.ramp = 0.1;
  inlet.extent = {Interval{0, box.scene.size[0]}, Interval{0, box.scene.size[1]}, Interval{0, 0}};
  box.scene.patches.push_back(inlet);
  const Grid& grid = box.grid();
  for (double& p : box.gas.pressure) p = 30;
  const double area = box.scene.size[0] * box.scene.size[1];
  const GasBoundary boundary(grid);
  const BoundaryAction full = boundary.action(box.gas, box.fraction, 1.2, 1), half = boundary.action(box.gas, box.fraction, 1.2, 0.05);
  EXPECT_NEAR(full.force[2], 1.2 * 2 * 2 * area, 1e-12 * area);   // an even pressure pushes nothing
  EXPECT_NEAR(half.force[2], 1.2 * 1 * 1 * area, 1e-12 * area);
  EXPECT_NEAR(full.pumping, 30 * 2 * area, 1e-12 * area);
}
