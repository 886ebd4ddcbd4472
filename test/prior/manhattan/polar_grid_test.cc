#include "prior/manhattan/polar_grid.h"

#include <cmath>
#include <memory>

#include <gtest/gtest.h>

namespace stereo_sgmp {
namespace {

constexpr double kDegree = 3.14159265358979323846 / 180.0;

Eigen::Vector3d At(double latitude, double longitude) {
  return {std::sin(latitude * kDegree) * std::cos(longitude * kDegree),
          std::sin(latitude * kDegree) * std::sin(longitude * kDegree),
          std::cos(latitude * kDegree)};
}

class PolarGridTest : public testing::Test {
 protected:
  const std::unique_ptr<PolarGrid> grid_ = std::make_unique<PolarGrid>();
};

TEST_F(PolarGridTest, AddsUpWithinADegree) {
  grid_->Add(At(30.2, 100.2), 1.0);
  grid_->Add(5.0 * At(30.8, 100.8), 2.0);
  grid_->Add(At(31.2, 100.2), 4.0);
  EXPECT_EQ(grid_->At(At(30.5, 100.5)), 3.0);
}

TEST_F(PolarGridTest, OppositeDirectionsAreOne) {
  grid_->Add(-At(30.5, 100.5), 1.0);
  EXPECT_EQ(grid_->At(At(30.5, 100.5)), 1.0);
}

TEST_F(PolarGridTest, SmoothingReachesTheNeighbours) {
  grid_->Add(At(30.5, 359.5), 1.0);
  grid_->Smooth();
  EXPECT_EQ(grid_->At(At(31.5, 0.5)), 1.0);
  EXPECT_EQ(grid_->At(At(29.5, 358.5)), 1.0);
  EXPECT_EQ(grid_->At(At(32.5, 359.5)), 0.0);
}

TEST_F(PolarGridTest, SmoothingPassesThePole) {
  grid_->Add(At(0.5, 10.5), 1.0);
  grid_->Smooth();
  EXPECT_EQ(grid_->At(At(0.5, 190.5)), 1.0);
}

// Directions parallel to the image: a little further on the opposite direction is the nearer.
TEST_F(PolarGridTest, SmoothingPassesTheEquator) {
  grid_->Add(At(89.5, 10.5), 1.0);
  grid_->Smooth();
  EXPECT_EQ(grid_->At(At(90.5, 10.5)), 1.0);
  EXPECT_EQ(grid_->At(At(89.5, 190.5)), 1.0);
}

}  // namespace
}  // namespace stereo_sgmp
