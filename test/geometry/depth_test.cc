#include "stereo_sgmp/depth.h"

#include <cmath>
#include <limits>
#include <stdexcept>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace stereo_sgmp {
namespace {

StereoCamera Camera() {
  StereoCamera camera;
  camera.focal_length = 500.0;
  camera.baseline = 0.1;
  camera.doffs = 5.0;
  return camera;
}

TEST(ComputeDepthTest, IsFocalLengthTimesBaselineByDisparity) {
  MatchResult result;
  result.dense = (cv::Mat_<float>(1, 4) << 20.0f, -5.0f, -6.0f, 45.0f);
  result.reason = (cv::Mat_<std::uint8_t>(1, 4) << 0, 0, 0, 3);
  cv::Mat depth;
  ComputeDepth(result, Camera(), &depth);
  EXPECT_FLOAT_EQ(depth.at<float>(0), 2.0f);
  EXPECT_TRUE(std::isnan(depth.at<float>(1))) << "at infinity";
  EXPECT_TRUE(std::isnan(depth.at<float>(2))) << "beyond infinity";
  EXPECT_TRUE(std::isnan(depth.at<float>(3))) << "invalid";
}

TEST(RangeOfDepthsTest, CoversTheDepthsAndNoMore) {
  const StereoCamera camera = Camera();
  const DisparityRange range = RangeOfDepths(camera, 0.7, 6.0);
  const int last = range.first + range.count - 1;
  EXPECT_GE(camera.DepthOf(range.first), 6.0);
  EXPECT_LT(camera.DepthOf(range.first + 1), 6.0);
  EXPECT_LE(camera.DepthOf(last), 0.7);
  EXPECT_GT(camera.DepthOf(last - 1), 0.7);
}

TEST(RangeOfDepthsTest, ReachesToInfinity) {
  const DisparityRange range =
      RangeOfDepths(Camera(), 1.0, std::numeric_limits<double>::infinity());
  EXPECT_EQ(range.first, -5);  // -doffs
  EXPECT_EQ(range.first + range.count - 1, 45);
}

TEST(RangeOfDepthsTest, RefusesRangesThatAreNone) {
  for (const double nearest : {0.0, -1.0, 2.0, std::nan("")}) {
    try {
      RangeOfDepths(Camera(), nearest, 2.0);
      ADD_FAILURE() << nearest;
    } catch (const std::invalid_argument& error) {
      EXPECT_THAT(error.what(), testing::HasSubstr("expected 0 < nearest < farthest"));
    }
  }
}

}  // namespace
}  // namespace stereo_sgmp
