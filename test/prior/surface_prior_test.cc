#include "prior/surface_prior.h"

#include <cmath>
#include <cstdint>
#include <limits>
#include <stdexcept>
#include <vector>

#include <gtest/gtest.h>

#include "prior/unpack_jumps.h"

namespace stereo_sgmp {
namespace {

VolumeShape Shape(int width, int height) {
  VolumeShape shape;
  shape.width = width;
  shape.height = height;
  shape.disparities = 16;
  return shape;
}

std::vector<std::int16_t> JumpsOf(const cv::Mat& surface, int y, PathStep step) {
  SurfacePrior prior;
  prior.Assign(surface, Shape(surface.cols, surface.rows));
  JumpRow row;
  prior.Jumps(y, 0, surface.cols, step, &row);
  EXPECT_TRUE(row.segments.empty());
  return Values(row.jump);
}

TEST(SurfacePrior, JumpIsDifferenceOfRoundedSurfaces) {
  const cv::Mat surface = (cv::Mat_<float>(1, 5) << 1.4F, 1.5F, 2.49F, -0.5F, -0.6F);
  EXPECT_EQ(JumpsOf(surface, 0, {1, 0}), (std::vector<std::int16_t>{0, 1, 0, -2, -1}));
  EXPECT_EQ(JumpsOf(surface, 0, {-1, 0}), (std::vector<std::int16_t>{-1, 0, 2, 1, 0}));
}

TEST(SurfacePrior, DiagonalStepReadsPixelBehind) {
  const cv::Mat surface = (cv::Mat_<float>(2, 3) << 1, 2, 3, 5, 7, 11);
  EXPECT_EQ(JumpsOf(surface, 1, {1, 1}), (std::vector<std::int16_t>{0, 6, 9}));
  EXPECT_EQ(JumpsOf(surface, 1, {-1, 1}), (std::vector<std::int16_t>{3, 4, 0}));
  EXPECT_EQ(JumpsOf(surface, 0, {1, 1}), (std::vector<std::int16_t>{0, 0, 0}));
}

TEST(SurfacePrior, UnknownPixelsHaveNoJump) {
  const float nan = std::numeric_limits<float>::quiet_NaN();
  const float inf = std::numeric_limits<float>::infinity();
  const cv::Mat surface = (cv::Mat_<float>(1, 6) << 1, nan, 9, 12, inf, 3);
  EXPECT_EQ(JumpsOf(surface, 0, {1, 0}), (std::vector<std::int16_t>{0, 0, 0, 3, 0, 0}));
}

TEST(SurfacePrior, WholeNumberAddedChangesNothing) {
  cv::Mat surface(4, 9, CV_32FC1);
  cv::randu(surface, 0.0, 15.0);
  const cv::Mat moved = surface + 7.0;
  EXPECT_EQ(JumpsOf(surface, 2, {0, 1}), JumpsOf(moved, 2, {0, 1}));
}

TEST(SurfacePrior, LimitsJumpsToTheRange) {
  const cv::Mat surface = (cv::Mat_<float>(1, 3) << 0, 1e9F, -1e9F);
  EXPECT_EQ(JumpsOf(surface, 0, {1, 0}), (std::vector<std::int16_t>{0, 16, -16}));
}

TEST(SurfacePrior, RefusesOtherSize) {
  SurfacePrior prior;
  EXPECT_THROW(prior.Assign(cv::Mat(2, 2, CV_32FC1), Shape(3, 2)), std::invalid_argument);
  EXPECT_THROW(prior.Assign(cv::Mat(2, 3, CV_8UC1), Shape(3, 2)), std::invalid_argument);
}

}  // namespace
}  // namespace stereo_sgmp
