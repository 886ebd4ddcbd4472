#include "refinement/speckle.h"

#include <cmath>
#include <cstddef>
#include <random>
#include <vector>

#include <gtest/gtest.h>

#include "stereo_sgmp/match_result.h"

namespace stereo_sgmp {
namespace {

constexpr auto kSpeckle = static_cast<std::uint8_t>(InvalidReason::kSpeckle);
constexpr auto kLeftRight = static_cast<std::uint8_t>(InvalidReason::kLeftRight);

cv::Mat Mark(const cv::Mat& disparity, const cv::Mat& reason, int size, double range,
             int threads = 2) {
  ThreadPool pool(threads);
  cv::Mat marked = reason.clone();
  SpeckleFilter().Mark(disparity, size, range, &marked, &pool);
  return marked;
}

// Flood fill pixel by pixel: the definition.
cv::Mat ReferenceMark(const cv::Mat& disparity, const cv::Mat& reason, int size, float range) {
  cv::Mat marked = reason.clone();
  cv::Mat seen = reason != 0;
  for (int y0 = 0; y0 < disparity.rows; ++y0) {
    for (int x0 = 0; x0 < disparity.cols; ++x0) {
      if (seen.at<std::uint8_t>(y0, x0) != 0) continue;
      std::vector<cv::Point> region = {{x0, y0}};
      seen.at<std::uint8_t>(y0, x0) = 255;
      for (std::size_t i = 0; i < region.size(); ++i) {
        const cv::Point p = region[i];
        for (const cv::Point step : {cv::Point(1, 0), {-1, 0}, {0, 1}, {0, -1}}) {
          const cv::Point q = p + step;
          if (!cv::Rect({0, 0}, disparity.size()).contains(q) || seen.at<std::uint8_t>(q) != 0) {
            continue;
          }
          if (std::abs(disparity.at<float>(p) - disparity.at<float>(q)) > range) continue;
          seen.at<std::uint8_t>(q) = 255;
          region.push_back(q);
        }
      }
      if (static_cast<int>(region.size()) >= size) continue;
      for (const cv::Point& p : region) marked.at<std::uint8_t>(p) = kSpeckle;
    }
  }
  return marked;
}

TEST(SpeckleTest, EqualsFloodFillOnRandomMaps) {
  std::mt19937 random(11);
  for (const cv::Size size : {cv::Size(1, 1), {1, 40}, {40, 1}, {2, 2}, {57, 43}, {64, 33}}) {
    for (const int levels : {2, 3, 6}) {
      cv::Mat disparity(size, CV_32F);
      cv::Mat reason(size, CV_8U);
      for (int y = 0; y < size.height; ++y) {
        for (int x = 0; x < size.width; ++x) {
          disparity.at<float>(y, x) = static_cast<float>(random() % static_cast<unsigned>(levels));
          reason.at<std::uint8_t>(y, x) = random() % 8 == 0 ? kLeftRight : std::uint8_t{0};
        }
      }
      for (const float range : {0.0f, 1.0f}) {
        const cv::Mat expected = ReferenceMark(disparity, reason, 9, range);
        for (const int threads : {1, 2, 5}) {
          const cv::Mat actual = Mark(disparity, reason, 9, range, threads);
          EXPECT_EQ(cv::countNonZero(expected != actual), 0) << size << levels << range;
        }
      }
    }
  }
}

TEST(SpeckleTest, OnlyRegionsBelowTheSizeAreMarked) {
  cv::Mat disparity(10, 10, CV_32F, cv::Scalar(5));
  disparity(cv::Rect(2, 2, 3, 2)).setTo(50);
  const cv::Mat valid = cv::Mat::zeros(10, 10, CV_8U);
  EXPECT_EQ(cv::countNonZero(Mark(disparity, valid, 6, 1.0)), 0);
  const cv::Mat marked = Mark(disparity, valid, 7, 1.0);
  EXPECT_EQ(cv::countNonZero(marked == kSpeckle), 6);
  EXPECT_EQ(marked.at<std::uint8_t>(2, 2), kSpeckle);
}

TEST(SpeckleTest, GentleSlopeIsOneRegion) {
  cv::Mat disparity(1, 50, CV_32F);
  for (int x = 0; x < 50; ++x) disparity.at<float>(0, x) = static_cast<float>(x);
  const cv::Mat valid = cv::Mat::zeros(1, 50, CV_8U);
  EXPECT_EQ(cv::countNonZero(Mark(disparity, valid, 50, 1.0)), 0);
  EXPECT_EQ(cv::countNonZero(Mark(disparity, valid, 50, 0.9)), 50);
}

TEST(SpeckleTest, CornersDoNotConnect) {
  const cv::Mat disparity = (cv::Mat_<float>(2, 2) << 1, 9, 9, 1);
  const cv::Mat marked = Mark(disparity, cv::Mat::zeros(2, 2, CV_8U), 2, 1.0);
  EXPECT_EQ(cv::countNonZero(marked == kSpeckle), 4);
}

TEST(SpeckleTest, BranchesThatMeetLaterAreOneRegion) {
  // A comb, whose teeth meet in the last row only.
  cv::Mat disparity(6, 9, CV_32F, cv::Scalar(1));
  cv::Mat reason = cv::Mat::zeros(6, 9, CV_8U);
  for (int x = 1; x < 9; x += 2) reason(cv::Rect(x, 0, 1, 5)).setTo(kLeftRight);
  EXPECT_EQ(cv::countNonZero(Mark(disparity, reason, 34, 0.0) == kSpeckle), 0);
  EXPECT_EQ(cv::countNonZero(Mark(disparity, reason, 35, 0.0) == kSpeckle), 34);
}

TEST(SpeckleTest, OtherReasonsAreKeptAndSizeOfOneIsOff) {
  const cv::Mat disparity(3, 3, CV_32F, cv::Scalar(1));
  cv::Mat reason(3, 3, CV_8U, cv::Scalar(kLeftRight));
  reason.at<std::uint8_t>(1, 1) = 0;
  EXPECT_EQ(cv::countNonZero(Mark(disparity, reason, 1, 1.0) != reason), 0);
  EXPECT_EQ(cv::countNonZero(Mark(disparity, reason, 0, 1.0) != reason), 0);
  const cv::Mat marked = Mark(disparity, reason, 2, 1.0);
  EXPECT_EQ(marked.at<std::uint8_t>(1, 1), kSpeckle);
  EXPECT_EQ(cv::countNonZero(marked == kLeftRight), 8);
}

}  // namespace
}  // namespace stereo_sgmp
