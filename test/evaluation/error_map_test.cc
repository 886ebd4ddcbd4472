#include "evaluation/error_map.h"

#include <cstdint>
#include <limits>

#include <gtest/gtest.h>

namespace stereo_sgmp {
namespace {

constexpr float kInfinity = std::numeric_limits<float>::infinity();

TEST(ErrorMap, ColorsByTheSizeOfTheError) {
  const cv::Mat truth = (cv::Mat_<float>(1, 7) << 50, 50, 50, 50, 50, 50, kInfinity);
  const cv::Mat disparity = (cv::Mat_<float>(1, 7) << 50, 52, 52.01F, 60, 99, kInfinity, 50);
  const cv::Mat_<cv::Vec3b> map =
      ErrorMap(disparity, truth, EvaluatedPixels(truth, cv::Mat()), {2.0});
  EXPECT_EQ(map(0, 0), map(0, 1)) << "both correct";
  EXPECT_EQ(map(0, 0)[0], map(0, 0)[2]) << "gray";
  EXPECT_NE(map(0, 2), map(0, 1));
  EXPECT_GT(map(0, 2)[1], map(0, 3)[1]) << "yellow turns red";
  EXPECT_GT(map(0, 3)[1], map(0, 4)[1]);
  EXPECT_GT(map(0, 5)[0], map(0, 5)[2]) << "blue where there is no disparity";
  EXPECT_LT(map(0, 6)[0] + map(0, 6)[1] + map(0, 6)[2], 120) << "dark where nothing is known";
}

TEST(ErrorMap, KnowsRelativeBounds) {
  const cv::Mat truth = (cv::Mat_<float>(1, 2) << 100, 10);
  const cv::Mat disparity = (cv::Mat_<float>(1, 2) << 104, 14);
  const cv::Mat_<cv::Vec3b> map =
      ErrorMap(disparity, truth, EvaluatedPixels(truth, cv::Mat()), {3.0, 0.05});
  EXPECT_EQ(map(0, 0)[0], map(0, 0)[2]) << "4 pixels are less than 5 %";
  EXPECT_NE(map(0, 1)[0], map(0, 1)[2]);
}

}  // namespace
}  // namespace stereo_sgmp
