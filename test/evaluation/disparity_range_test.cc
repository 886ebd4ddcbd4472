#include "evaluation/disparity_range.h"

#include <limits>

#include <gtest/gtest.h>

namespace stereo_sgmp {
namespace {

constexpr float kInfinity = std::numeric_limits<float>::infinity();

StereoScene SceneUpTo(float largest) {
  StereoScene scene;
  scene.left = cv::Mat::zeros(2, 200, CV_8U);
  scene.disparity = cv::Mat(2, 200, CV_32F, cv::Scalar(kInfinity));
  scene.disparity.at<float>(0, 3) = largest;
  scene.disparity.at<float>(1, 3) = largest / 2;
  return scene;
}

TEST(DisparitiesToSearch, TakesThoseOfTheCalibration) {
  StereoScene scene = SceneUpTo(30);
  scene.calibration.emplace();
  scene.calibration->num_disparities = 77;
  EXPECT_EQ(DisparitiesToSearch(scene, Options()), 77);
}

TEST(DisparitiesToSearch, CoversTheGroundTruthAndAMargin) {
  EXPECT_EQ(DisparitiesToSearch(SceneUpTo(30), Options()), 34);
  Options options;
  options.min_disparity = -5;
  EXPECT_EQ(DisparitiesToSearch(SceneUpTo(30), options), 39);
  options.min_disparity = 100;
  EXPECT_EQ(DisparitiesToSearch(SceneUpTo(30), options), 1);
  EXPECT_EQ(DisparitiesToSearch(SceneUpTo(1e9F), Options()), 200);
}

TEST(DisparitiesToSearch, FallsBackToTheOptions) {
  EXPECT_EQ(DisparitiesToSearch(SceneUpTo(kInfinity), Options()), Options().num_disparities);
  Options options;
  options.num_disparities = 300;
  EXPECT_EQ(DisparitiesToSearch(SceneUpTo(kInfinity), options), 200);
}

}  // namespace
}  // namespace stereo_sgmp
