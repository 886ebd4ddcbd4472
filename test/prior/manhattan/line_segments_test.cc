#include "prior/manhattan/line_segments.h"

#include <algorithm>
#include <cmath>
#include <stdexcept>

#include <gtest/gtest.h>
#include <opencv2/imgproc.hpp>

#include "prior/manhattan/line_detector.h"

namespace stereo_sgmp {
namespace {

cv::Mat Rectangle(cv::Size size, const cv::Rect& where) {
  cv::Mat image(size, CV_8UC1, cv::Scalar(60));
  image(where).setTo(150);
  cv::GaussianBlur(image, image, cv::Size(), 0.8);
  return image;
}

double DistanceToEdge(const Eigen::Vector2d& p, const cv::Rect& edge) {
  const double x =
      std::min(std::abs(p.x() - (edge.x - 0.5)), std::abs(p.x() - (edge.x + edge.width - 0.5)));
  const double y =
      std::min(std::abs(p.y() - (edge.y - 0.5)), std::abs(p.y() - (edge.y + edge.height - 0.5)));
  return std::min(x, y);
}

class LineSegmentsOf : public testing::TestWithParam<int> {};

TEST_P(LineSegmentsOf, FindsTheSidesOfARectangleInItsPixels) {
  if (!kHasLineDetector) GTEST_SKIP();
  const int scale = GetParam();
  const cv::Rect where(60 * scale, 40 * scale, 200 * scale, 120 * scale);
  const auto lines = FindLineSegments(Rectangle({400 * scale, 240 * scale}, where));
  ASSERT_EQ(lines.size(), 4U);
  EXPECT_NEAR(lines[0].Length(), 200.0 * scale, 8.0 * scale);
  EXPECT_NEAR(lines[3].Length(), 120.0 * scale, 8.0 * scale);
  for (const LineSegment& line : lines) {
    EXPECT_LT(DistanceToEdge(line.start, where), 0.5 * scale);
    EXPECT_LT(DistanceToEdge(line.end, where), 0.5 * scale);
  }
}

// The larger image is reduced.
INSTANTIATE_TEST_SUITE_P(Scales, LineSegmentsOf, testing::Values(1, 6));

TEST(LineSegments, ColourGivesTheLinesOfItsGray) {
  if (!kHasLineDetector) GTEST_SKIP();
  const cv::Mat gray = Rectangle({400, 240}, {60, 40, 200, 120});
  for (const int conversion : {cv::COLOR_GRAY2BGR, cv::COLOR_GRAY2BGRA}) {
    cv::Mat color;
    cv::cvtColor(gray, color, conversion);
    EXPECT_EQ(FindLineSegments(color).size(), 4U);
  }
}

TEST(LineSegments, ShortEdgesAreLeftOut) {
  if (!kHasLineDetector) GTEST_SKIP();
  EXPECT_TRUE(FindLineSegments(Rectangle({400, 240}, {60, 40, 8, 8})).empty());
}

TEST(LineSegments, PlainAndTinyImagesHaveNone) {
  if (!kHasLineDetector) GTEST_SKIP();
  EXPECT_TRUE(FindLineSegments(cv::Mat(240, 320, CV_8UC1, cv::Scalar(90))).empty());
  EXPECT_TRUE(FindLineSegments(cv::Mat(1, 1, CV_8UC1, cv::Scalar(90))).empty());
}

TEST(LineSegments, OtherImagesAreRejected) {
  EXPECT_THROW(FindLineSegments(cv::Mat()), std::invalid_argument);
  EXPECT_THROW(FindLineSegments(cv::Mat(20, 20, CV_16UC1, cv::Scalar(0))), std::invalid_argument);
  EXPECT_THROW(FindLineSegments(cv::Mat(20, 20, CV_8UC2, cv::Scalar(0))), std::invalid_argument);
}

}  // namespace
}  // namespace stereo_sgmp
