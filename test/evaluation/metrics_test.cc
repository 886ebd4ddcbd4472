#include "evaluation/metrics.h"

#include <cmath>
#include <cstdint>
#include <limits>
#include <stdexcept>

#include <gtest/gtest.h>

namespace stereo_sgmp {
namespace {

constexpr float kInfinity = std::numeric_limits<float>::infinity();
constexpr float kNan = std::numeric_limits<float>::quiet_NaN();

TEST(EvaluatedPixels, AreKnownAndSeenByBothCameras) {
  const cv::Mat truth = (cv::Mat_<float>(1, 6) << 5, kInfinity, 5, 5, 0, kNan);
  const cv::Mat mask = (cv::Mat_<std::uint8_t>(1, 6) << 255, 255, 128, 0, 255, 255);
  const cv::Mat expected = (cv::Mat_<std::uint8_t>(1, 6) << 255, 0, 0, 0, 0, 0);
  EXPECT_EQ(cv::norm(EvaluatedPixels(truth, mask), expected, cv::NORM_INF), 0);
  const cv::Mat without_mask = (cv::Mat_<std::uint8_t>(1, 6) << 255, 0, 255, 255, 0, 0);
  EXPECT_EQ(cv::norm(EvaluatedPixels(truth, cv::Mat()), without_mask, cv::NORM_INF), 0);
  const cv::Mat with_zero = (cv::Mat_<std::uint8_t>(1, 6) << 255, 0, 255, 255, 255, 0);
  EXPECT_EQ(
      cv::norm(EvaluatedPixels(truth, cv::Mat(), ZeroTruth::kDisparity), with_zero, cv::NORM_INF),
      0);
}

TEST(BadPercent, CountsErrorsAboveTheThresholdAndInvalidPixels) {
  const cv::Mat truth = (cv::Mat_<float>(1, 8) << 10, 10, 10, 10, 10, 10, 10, kInfinity);
  const cv::Mat disparity =
      (cv::Mat_<float>(1, 8) << 10, 11, 11.25F, 9, 8.5F, kInfinity, kNan, kInfinity);
  const cv::Mat evaluated = EvaluatedPixels(truth, cv::Mat());
  EXPECT_DOUBLE_EQ(BadPercent(disparity, truth, evaluated, {1.0}), 100.0 * 4 / 7);
  EXPECT_DOUBLE_EQ(BadPercent(disparity, truth, evaluated, {0.5}), 100.0 * 6 / 7);
  EXPECT_DOUBLE_EQ(BadPercent(disparity, truth, evaluated, {2.0}), 100.0 * 2 / 7);
  EXPECT_DOUBLE_EQ(AverageError(disparity, truth, evaluated), (0 + 1 + 1.25 + 1 + 1.5) / 5);
}

TEST(BadPercent, CountsErrorsAboveBothBounds) {
  const cv::Mat truth = (cv::Mat_<float>(1, 4) << 100, 100, 40, 40);
  const cv::Mat disparity = (cv::Mat_<float>(1, 4) << 104, 106, 42.5F, 43.5F);
  const cv::Mat evaluated = EvaluatedPixels(truth, cv::Mat());
  EXPECT_DOUBLE_EQ(BadPercent(disparity, truth, evaluated, {3.0, 0.0}), 75);
  EXPECT_DOUBLE_EQ(BadPercent(disparity, truth, evaluated, {3.0, 0.05}), 50);
  EXPECT_DOUBLE_EQ(BadPercent(disparity, truth, evaluated, {0.0, 0.05}), 75);
}

TEST(PercentOf, IsTheShareOfTheEvaluatedPixels) {
  const cv::Mat evaluated = (cv::Mat_<std::uint8_t>(1, 5) << 255, 255, 255, 255, 0);
  const cv::Mat mask = (cv::Mat_<std::uint8_t>(1, 5) << 255, 0, 0, 0, 255);
  EXPECT_DOUBLE_EQ(PercentOf(evaluated, mask), 25);
  EXPECT_TRUE(std::isnan(PercentOf(cv::Mat::zeros(1, 5, CV_8U), mask)));
}

TEST(BadPercent, IsNotANumberWithoutPixels) {
  const cv::Mat truth(1, 3, CV_32F, cv::Scalar(kInfinity));
  const cv::Mat evaluated = EvaluatedPixels(truth, cv::Mat());
  EXPECT_TRUE(std::isnan(BadPercent(truth, truth, evaluated, {1})));
  EXPECT_TRUE(std::isnan(AverageError(truth, truth, evaluated)));
}

TEST(BadPercent, RefusesMapsOfOtherSizes) {
  const cv::Mat truth(2, 3, CV_32F, cv::Scalar(1));
  const cv::Mat evaluated = EvaluatedPixels(truth, cv::Mat());
  EXPECT_THROW(BadPercent(truth.colRange(0, 2), truth, evaluated, {1}), std::invalid_argument);
  EXPECT_THROW(EvaluatedPixels(truth, evaluated.colRange(0, 2)), std::invalid_argument);
}

}  // namespace
}  // namespace stereo_sgmp
