#include "stereo_sgmp/point_cloud.h"

#include <cmath>
#include <cstddef>
#include <cstdint>
#include <cstring>
#include <stdexcept>

#include <gtest/gtest.h>

namespace stereo_sgmp {
namespace {

StereoCamera Camera() {
  StereoCamera camera;
  camera.focal_length = 100.0;
  camera.cx = 1.5;
  camera.cy = 0.5;
  camera.doffs = 2.0;
  camera.baseline = 0.2;
  return camera;
}

MatchResult ResultOf(int width, int height, float disparity) {
  MatchResult result;
  result.dense = cv::Mat(height, width, CV_32F, cv::Scalar(disparity));
  result.confidence = cv::Mat(height, width, CV_32F, cv::Scalar(0.75));
  result.reason = cv::Mat::zeros(height, width, CV_8U);
  return result;
}

PointCloud CloudOf(const MatchResult& result, const cv::Mat& image,
                   const CloudOptions& options = {}) {
  PointCloud cloud;
  ComputePointCloud(result, Camera(), image, options, &cloud);
  return cloud;
}

cv::Mat GrayOf(const MatchResult& result) {
  return cv::Mat(result.dense.size(), CV_8U, cv::Scalar(50));
}

bool IsMissing(const CloudPoint& point) {
  return std::isnan(point.x) && std::isnan(point.y) && std::isnan(point.z);
}

TEST(PointCloudTest, PointsAreThoseOfTheCameraModel) {
  MatchResult result = ResultOf(5, 3, 0.0f);
  for (int y = 0; y < 3; ++y) {
    for (int x = 0; x < 5; ++x) result.dense.at<float>(y, x) = static_cast<float>(1 + x + 7 * y);
  }
  const PointCloud cloud = CloudOf(result, GrayOf(result));
  ASSERT_EQ(cloud.width, 5);
  ASSERT_EQ(cloud.height, 3);
  ASSERT_EQ(cloud.points.size(), 15u);
  for (int y = 0; y < 3; ++y) {
    for (int x = 0; x < 5; ++x) {
      const Eigen::Vector3d expected = Camera().PointAt(x, y, result.dense.at<float>(y, x));
      const CloudPoint& point = cloud.points[static_cast<std::size_t>(y * 5 + x)];
      EXPECT_NEAR(point.x, expected.x(), 1e-5);
      EXPECT_NEAR(point.y, expected.y(), 1e-5);
      EXPECT_NEAR(point.z, expected.z(), 1e-5);
      EXPECT_EQ(point.confidence, 0.75f);
    }
  }
}

TEST(PointCloudTest, InvalidPixelsAreNanAndKeepColourAndConfidence) {
  MatchResult result = ResultOf(2, 1, 8.0f);
  result.reason.at<std::uint8_t>(0, 1) = static_cast<std::uint8_t>(InvalidReason::kSpeckle);
  const PointCloud cloud = CloudOf(result, GrayOf(result));
  EXPECT_FALSE(IsMissing(cloud.points[0]));
  EXPECT_TRUE(IsMissing(cloud.points[1]));
  EXPECT_EQ(cloud.points[1].g, 50);
  EXPECT_EQ(cloud.points[1].confidence, 0.75f);
}

TEST(PointCloudTest, PointsAtOrBeyondInfinityAreNan) {
  EXPECT_TRUE(IsMissing(CloudOf(ResultOf(1, 1, -2.0f), cv::Mat(1, 1, CV_8U)).points[0]));
  EXPECT_TRUE(IsMissing(CloudOf(ResultOf(1, 1, -9.0f), cv::Mat(1, 1, CV_8U)).points[0]));
}

TEST(PointCloudTest, ConfidenceAndDepthLimitsAreInclusive) {
  const MatchResult result = ResultOf(1, 1, 8.0f);  // z = 20 / 10
  const cv::Mat image = GrayOf(result);
  CloudOptions options;
  options.max_depth = 2.0;
  options.min_confidence = 0.75;
  EXPECT_FALSE(IsMissing(CloudOf(result, image, options).points[0]));
  options.max_depth = 1.99;
  EXPECT_TRUE(IsMissing(CloudOf(result, image, options).points[0]));
  options.max_depth = 2.0;
  options.min_confidence = 0.76;
  EXPECT_TRUE(IsMissing(CloudOf(result, image, options).points[0]));
}

TEST(PointCloudTest, ColoursOfAllImageTypes) {
  const MatchResult result = ResultOf(1, 1, 8.0f);
  const auto expect = [&](const cv::Mat& image, int b, int g, int r) {
    const CloudPoint point = CloudOf(result, image).points[0];
    EXPECT_EQ(point.b, b);
    EXPECT_EQ(point.g, g);
    EXPECT_EQ(point.r, r);
    EXPECT_EQ(point.unused, 0);
  };
  expect(cv::Mat(1, 1, CV_8UC1, cv::Scalar(9)), 9, 9, 9);
  expect(cv::Mat(1, 1, CV_8UC3, cv::Scalar(1, 2, 3)), 1, 2, 3);
  expect(cv::Mat(1, 1, CV_8UC4, cv::Scalar(1, 2, 3, 4)), 1, 2, 3);
  expect(cv::Mat(1, 1, CV_16UC1, cv::Scalar(0x1234)), 0x12, 0x12, 0x12);
  expect(cv::Mat(1, 1, CV_16UC3, cv::Scalar(0x1234, 0x56FF, 0xFF00)), 0x12, 0x56, 0xFF);
}

TEST(PointCloudTest, ColourIsThePackedWordThatPclReads) {
  const MatchResult result = ResultOf(1, 1, 8.0f);
  const PointCloud cloud = CloudOf(result, cv::Mat(1, 1, CV_8UC3, cv::Scalar(1, 2, 3)));
  std::uint32_t rgb = 0;
  std::memcpy(&rgb, reinterpret_cast<const char*>(cloud.points.data()) + offsetof(CloudPoint, b),
              sizeof(rgb));
  EXPECT_EQ(rgb, 0x00030201u);
}

TEST(PointCloudTest, CloudIsReusedForAnotherSize) {
  PointCloud cloud;
  const MatchResult large = ResultOf(4, 4, 8.0f);
  const MatchResult small = ResultOf(2, 3, 8.0f);
  ComputePointCloud(large, Camera(), GrayOf(large), {}, &cloud);
  const CloudPoint* storage = cloud.points.data();
  ComputePointCloud(small, Camera(), GrayOf(small), {}, &cloud);
  EXPECT_EQ(cloud.points.size(), 6u);
  EXPECT_EQ(cloud.points.data(), storage);
}

TEST(PointCloudTest, UnfitImagesAndCamerasAreRejected) {
  const MatchResult result = ResultOf(2, 2, 8.0f);
  EXPECT_THROW(CloudOf(result, cv::Mat(2, 3, CV_8U)), std::invalid_argument);
  EXPECT_THROW(CloudOf(result, cv::Mat(2, 2, CV_32F)), std::invalid_argument);
  EXPECT_THROW(CloudOf(result, cv::Mat(2, 2, CV_8UC2)), std::invalid_argument);
  PointCloud cloud;
  EXPECT_THROW(ComputePointCloud(result, StereoCamera(), GrayOf(result), {}, &cloud),
               std::invalid_argument);
}

}  // namespace
}  // namespace stereo_sgmp
