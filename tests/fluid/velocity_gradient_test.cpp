#include <gtest/gtest.h>

#include <vector>

#include "boxes.h"
#include "fluid/velocity_gradient.h"

namespace similitude {
namespace {

using test::Box;

/// u = G x at cell centres.
std::vector<double> linear_flow(const Staggered& mesh, const VelocityGradient& slopes) {
  std::vector<double> velocity(static_cast<std::size_t>(3 * mesh.cell_count));
  Triple at{};
  for (at[2] = 0; at[2] < mesh.cells[2]; ++at[2]) {
    for (at[1] = 0; at[1] < mesh.cells[1]; ++at[1]) {
      for (at[0] = 0; at[0] < mesh.cells[0]; ++at[0]) {
        for (std::size_t a = 0; a < 3; ++a) {
          double u = 0;
          for (std::size_t b = 0; b < 3; ++b) u += slopes[a][b] * (static_cast<double>(at[b]) + 0.5) * mesh.spacing[b];
          velocity[a * static_cast<std::size_t>(mesh.cell_count) + static_cast<std::size_t>(mesh.cell(at))] = u;
        }
      }
    }
  }
  return velocity;
}

TEST(VelocityGradient, IsExactInALinearFlow) {
  Box box({.cells = {5, 5, 5}, .spacing = {0.1, 0.2, 0.3}});
  const VelocityGradient slopes{{{1, 2, -3}, {4, -5, 6}, {7, 8, 4}}};
  const Staggered mesh = box.mesh();
  const VelocityGradient found = velocity_gradient(mesh, linear_flow(mesh, slopes).data(), {2, 2, 2}, 0);
  for (std::size_t a = 0; a < 3; ++a) {
    for (std::size_t b = 0; b < 3; ++b) EXPECT_NEAR(found[a][b], slopes[a][b], 1e-12) << a << b;
  }
}

// Simple shear du/dy = s: sqrt(2 S:S) = s, vorticity -s along z.
TEST(VelocityGradient, OfASimpleShearHasItsRateAsStrainAndVorticity) {
  const VelocityGradient shear{{{0, 3, 0}, {0, 0, 0}, {0, 0, 0}}};
  EXPECT_DOUBLE_EQ(strain_rate(shear), 3);
  EXPECT_DOUBLE_EQ(vorticity(shear)[2], -3);
}

// Solid rotation strains nothing.
TEST(VelocityGradient, OfASolidRotationHasNoStrain) {
  const VelocityGradient turning{{{0, -2, 0}, {2, 0, 0}, {0, 0, 0}}};
  EXPECT_DOUBLE_EQ(strain_rate(turning), 0);
  EXPECT_DOUBLE_EQ(vorticity(turning)[2], 4);
}

// A shear between walls, one of which rests at y = 0: the wall cell sees the same slope as the others.
TEST(VelocityGradient, SeesTheSlopeToARestingWallAndNoneAlongASlipWall) {
  Box resting({.cells = {3, 4, 3}, .spacing = {1, 0.5, 1}, .periodic = {true, false, true}});
  Box slippery({.cells = {3, 4, 3}, .spacing = {1, 0.5, 1}, .periodic = {true, false, true}, .walls = SIMILITUDE_FACE_SLIP});
  const VelocityGradient slopes{{{0, 3, 0}, {0, 0, 0}, {0, 0, 0}}};
  const std::vector<double> velocity = linear_flow(resting.mesh(), slopes);
  EXPECT_NEAR(velocity_gradient(resting.mesh(), velocity.data(), {1, 0, 1}, 0)[0][1], 3, 1e-12);
  EXPECT_NEAR(velocity_gradient(slippery.mesh(), velocity.data(), {1, 0, 1}, 0)[0][1], 1.5, 1e-12);
}

}  // namespace
}  // namespace similitude
