#include "matcher/camera_order.h"

#include <gtest/gtest.h>

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
    // Bars that repeat match in any order.
    const bool repeats = kind == SceneKind::kFence;
    EXPECT_EQ(LookSwapped(scene.right, scene.left, options), !repeats);
  }
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
