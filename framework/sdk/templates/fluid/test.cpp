#include <gtest/gtest.h>

#include <vector>

#include "@name@.h"

namespace {

TEST(@Type@, RisesEverywhereWithItsVelocity) {
  similitude_grid grid{};
  grid.struct_size = sizeof grid;
  std::fill_n(grid.cells, 3, 2);
  std::fill_n(grid.spacing, 3, 5e-3);
  std::vector<double> velocity(3 * 8, -1), pressure(8, -1), stress_force(3 * 8, -1);
  similitude_gas_step fields{};
  fields.struct_size = sizeof fields;
  fields.velocity = velocity.data();
  fields.pressure = pressure.data();
  fields.stress_force = stress_force.data();

  @Type@ solver{};
  solver.velocity = 3;
  solver.initialise(grid, fields);
  for (int cell = 0; cell < 8; ++cell) {
    EXPECT_EQ(velocity[static_cast<std::size_t>(cell)], 0);
    EXPECT_EQ(velocity[static_cast<std::size_t>(16 + cell)], 3);
  }
}

}  // namespace
