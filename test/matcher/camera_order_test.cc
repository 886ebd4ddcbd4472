#include "matcher/camera_order.h"

#include <gtest/gtest.h>

#include "matcher/repeating_pair.h"
#include "scene/generated_scene.h"

namespace stereo_sgmp {
namespace {

TEST(LookSwappedTest, TellsPairsFromExchangedOnes) {
  for (const SceneKind kind : {SceneKind::kRoom, SceneKind::kCorridor, SceneKind::kFence,
                               SceneKind::kFrontoParallel, SceneKind::kCurved}) {
    SCOPED_TRACE(static_cast<int>(kind));
    const GeneratedScene scene = MakeScene(kind, {240, 180}, 48, {}, 6);
    Options options;
    options.num_disparities = scene.num_disparities;
    EXPECT_FALSE(LookSwapped(scene.left, scene.right, options));
    EXPECT_TRUE(LookSwapped(scene.right, scene.left, options));
  }
}

TEST(LookSwappedTest, IsNotMisledByTextureThatRepeatsWithinTheRange) {
  Options options;
  options.num_disparities = 48;
  for (const double period : {9.0, 14.0, 20.0, 27.0}) {
    SCOPED_TRACE(period);
    const RepeatingPair pair = MakeRepeatingPair({240, 180}, period, 10.0);
    EXPECT_FALSE(LookSwapped(pair.left, pair.right, options));
    EXPECT_TRUE(LookSwapped(pair.right, pair.left, options));
  }
}

TEST(LookSwappedTest, SaysNothingWhereBothOrdersMatchAsWell) {
  const cv::Mat wall = RepeatingWall({240, 180}, 14.0);
  const cv::Mat moved = RepeatingWall({240, 180}, 14.0, 7.0);  // half a period, either way
  for (const int disparities : {5, 10, 48}) {
    Options options;
    options.num_disparities = disparities;
    EXPECT_FALSE(LookSwapped(wall, moved, options)) << disparities;
    EXPECT_FALSE(LookSwapped(moved, wall, options)) << disparities;
  }
}

TEST(LookSwappedTest, DoesNotBlameTextureNearerThanTheRange) {
  Options options;
  options.num_disparities = 10;  // the wall is at 13, or at 1 of the exchanged pair
  const cv::Mat wall = RepeatingWall({240, 180}, 14.0);
  EXPECT_FALSE(LookSwapped(wall, RepeatingWall({240, 180}, 14.0, 13.0), options));
}

TEST(LookSwappedTest, DoesNotBlameImagesWithoutTextureOrMatches) {
  const cv::Mat gray(240, 320, CV_8U, cv::Scalar(128));
  cv::Mat noise(240, 320, CV_8U);
  cv::Mat other(240, 320, CV_8U);
  cv::RNG random(1);
  random.fill(noise, cv::RNG::UNIFORM, 0, 256);
  random.fill(other, cv::RNG::UNIFORM, 0, 256);
  EXPECT_FALSE(LookSwapped(gray, gray, Options()));
  EXPECT_FALSE(LookSwapped(noise, other, Options()));
  EXPECT_FALSE(LookSwapped(cv::Mat(8, 12, CV_8U, cv::Scalar(0)),
                           cv::Mat(8, 12, CV_8U, cv::Scalar(0)), Options()));
}

}  // namespace
}  // namespace stereo_sgmp
