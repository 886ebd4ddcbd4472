#include "prior/plane_hypotheses.h"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <functional>
#include <limits>
#include <stdexcept>
#include <vector>

#include <gtest/gtest.h>

namespace stereo_sgmp {
namespace {

constexpr int kMinArea = 60;

using Surface = std::function<double(int x, int y)>;

cv::Mat Render(int width, int height, const Surface& surface) {
  cv::Mat disparity(height, width, CV_32FC1);
  for (int y = 0; y < height; ++y) {
    for (int x = 0; x < width; ++x) {
      disparity.at<float>(y, x) = static_cast<float>(surface(x, y));
    }
  }
  return disparity;
}

void AddNoise(double sigma, double outliers, cv::Mat* disparity) {
  cv::RNG random(11);
  for (int y = 0; y < disparity->rows; ++y) {
    for (int x = 0; x < disparity->cols; ++x) {
      float& d = disparity->at<float>(y, x);
      d += static_cast<float>(random.gaussian(sigma));
      if (random.uniform(0.0, 1.0) < outliers) d = random.uniform(0.0F, 60.0F);
    }
  }
}

cv::Mat AllOf(const cv::Mat& disparity) {
  return cv::Mat(disparity.size(), CV_8UC1, cv::Scalar(255));
}

PlaneMap Find(const cv::Mat& disparity, const cv::Mat& confident) {
  PlaneHypotheses hypotheses;
  hypotheses.Find({disparity, confident}, kMinArea, nullptr);
  return hypotheses.map();
}

std::int16_t LabelAt(const PlaneMap& map, int x, int y) {
  return map.labels.at<std::int16_t>(y, x);
}

void ExpectPlaneAt(const PlaneMap& map, int x, int y, const DisparityPlane& expected) {
  const std::int16_t label = LabelAt(map, x, y);
  ASSERT_GE(label, 0) << "no plane at " << x << " " << y;
  const DisparityPlane& plane = map.planes[static_cast<std::size_t>(label)].plane;
  EXPECT_NEAR(plane.a, expected.a, 0.01);
  EXPECT_NEAR(plane.b, expected.b, 0.01);
  EXPECT_NEAR(plane.At(x, y), expected.At(x, y), 0.15);
}

TEST(PlaneHypotheses, RecoversNoisySlantedPlanesAcrossAStep) {
  const DisparityPlane left{0.15, -0.05, 10.0};
  const DisparityPlane right{-0.1, 0.1, 45.0};
  cv::Mat disparity =
      Render(120, 80, [&](int x, int y) { return x < 60 ? left.At(x, y) : right.At(x, y); });
  AddNoise(0.1, 0.05, &disparity);
  const PlaneMap map = Find(disparity, AllOf(disparity));
  ExpectPlaneAt(map, 30, 41, left);
  ExpectPlaneAt(map, 90, 41, right);
  EXPECT_EQ(map.planes.size(), 2U);
  EXPECT_GT(map.planes[0].area + map.planes[1].area, 120 * 80 * 9 / 10);
  EXPECT_NEAR(map.planes[0].rms, 0.1, 0.03);
}

TEST(PlaneHypotheses, PlanesThatMeetAtACreaseStayApart) {
  const DisparityPlane left{0.25, 0.0, 5.0};
  const DisparityPlane right{-0.25, 0.0, 35.0};  // the same at x = 60
  cv::Mat disparity =
      Render(120, 60, [&](int x, int y) { return std::min(left.At(x, y), right.At(x, y)); });
  AddNoise(0.05, 0.0, &disparity);
  const PlaneMap map = Find(disparity, AllOf(disparity));
  ExpectPlaneAt(map, 20, 30, left);
  ExpectPlaneAt(map, 100, 30, right);
  EXPECT_NE(LabelAt(map, 50, 30), LabelAt(map, 70, 30));
}

TEST(PlaneHypotheses, GrowsOverSmallGapsOnly) {
  const cv::Mat disparity = Render(100, 40, [](int, int) { return 12.0; });
  cv::Mat confident = AllOf(disparity);
  confident.col(30).setTo(0);
  confident.colRange(60, 66).setTo(0);
  const PlaneMap map = Find(disparity, confident);
  EXPECT_EQ(LabelAt(map, 10, 20), LabelAt(map, 50, 20));
  EXPECT_NE(LabelAt(map, 50, 20), LabelAt(map, 80, 20));
  EXPECT_EQ(LabelAt(map, 30, 20), -1);
}

TEST(PlaneHypotheses, LabelsAreNearTheirPlaneAndSortedByArea) {
  cv::Mat disparity = Render(150, 90, [](int x, int y) { return 20 + 0.002 * x * x + 0.1 * y; });
  AddNoise(0.1, 0.1, &disparity);
  const PlaneMap map = Find(disparity, AllOf(disparity));
  ASSERT_GT(map.planes.size(), 1U);
  std::vector<int> area(map.planes.size(), 0);
  for (int y = 0; y < map.labels.rows; ++y) {
    for (int x = 0; x < map.labels.cols; ++x) {
      if (LabelAt(map, x, y) < 0) continue;
      const auto label = static_cast<std::size_t>(LabelAt(map, x, y));
      ++area[label];
      EXPECT_LT(std::abs(map.planes[label].plane.At(x, y) - disparity.at<float>(y, x)), 0.601);
    }
  }
  for (std::size_t i = 0; i < area.size(); ++i) {
    EXPECT_EQ(area[i], map.planes[i].area);
    EXPECT_GE(area[i], kMinArea);
    if (i > 0) {
      EXPECT_LE(area[i], area[i - 1]);
    }
  }
}

// Disparities spread evenly over 12 +- `range`.
cv::Mat EvenNoise(float range) {
  cv::Mat disparity(60, 80, CV_32FC1);
  cv::RNG random(3);
  random.fill(disparity, cv::RNG::UNIFORM, 12.0F - range, 12.0F + range);
  return disparity;
}

TEST(PlaneHypotheses, NoiseThatFillsTheRangeOfAPlaneIsNone) {
  const cv::Mat narrow = EvenNoise(0.4F);  // a root mean square of 0.23
  const PlaneMap map = Find(narrow, AllOf(narrow));
  ASSERT_EQ(map.planes.size(), 1U);
  EXPECT_EQ(map.planes[0].area, 60 * 80);
  for (const float range : {0.6F, 3.0F}) {
    const cv::Mat wide = EvenNoise(range);
    EXPECT_TRUE(Find(wide, AllOf(wide)).planes.empty()) << range;
  }
}

TEST(PlaneHypotheses, ThePixelsOfARegionThatIsNoPlaneStayFree) {
  // Noise beside a plane, which grows in part into it: that plane is found all the same.
  cv::Mat disparity = EvenNoise(1.0F);
  disparity.colRange(0, 40).setTo(12.0);
  const PlaneMap map = Find(disparity, AllOf(disparity));
  ASSERT_GE(map.planes.size(), 1U);
  ExpectPlaneAt(map, 15, 30, {0.0, 0.0, 12.0});
}

TEST(PlaneHypotheses, SmallImagesHaveSmallerPlanes) {
  PriorOptions options;
  options.min_plane_area = 800;
  EXPECT_EQ(SmallestPlane(options, {400, 300}), 800);
  EXPECT_EQ(SmallestPlane(options, {100, 75}), 150);
  EXPECT_EQ(SmallestPlane(options, {6, 5}), 1);
}

TEST(PlaneHypotheses, SameForAnyThreadsAndBufferState) {
  cv::Mat disparity = Render(133, 71, [](int x, int y) { return 30 + 0.2 * x - 0.001 * y * y; });
  AddNoise(0.2, 0.2, &disparity);
  const PlaneMap expected = Find(disparity, AllOf(disparity));
  ThreadPool threads(3);
  PlaneHypotheses hypotheses;
  for (int repeat = 0; repeat < 2; ++repeat) {
    hypotheses.Find({disparity, AllOf(disparity)}, kMinArea, &threads);
    ASSERT_EQ(hypotheses.map().planes.size(), expected.planes.size());
    EXPECT_EQ(cv::norm(hypotheses.map().labels, expected.labels, cv::NORM_INF), 0.0);
    for (std::size_t i = 0; i < expected.planes.size(); ++i) {
      EXPECT_EQ(hypotheses.map().planes[i].plane.c, expected.planes[i].plane.c);
    }
  }
}

TEST(PlaneHypotheses, NothingConfidentOrTinyMapsGiveNoPlanes) {
  for (const cv::Size size : {cv::Size(1, 1), cv::Size(9, 1), cv::Size(1, 9), cv::Size(50, 50)}) {
    const cv::Mat disparity(size, CV_32FC1, cv::Scalar(5));
    const PlaneMap map = Find(disparity, cv::Mat::zeros(size, CV_8UC1));
    EXPECT_TRUE(map.planes.empty());
    EXPECT_EQ(map.labels.size(), size);
    EXPECT_EQ(cv::countNonZero(map.labels != -1), 0);
  }
  const cv::Mat unknown(40, 40, CV_32FC1, cv::Scalar(std::numeric_limits<float>::quiet_NaN()));
  EXPECT_TRUE(Find(unknown, AllOf(unknown)).planes.empty());
}

TEST(PlaneHypotheses, RefusesMapsThatDontFit) {
  const cv::Mat disparity(4, 4, CV_32FC1, cv::Scalar(0));
  EXPECT_THROW(Find(disparity, cv::Mat::zeros(4, 5, CV_8UC1)), std::invalid_argument);
  EXPECT_THROW(Find(cv::Mat::zeros(4, 4, CV_16SC1), AllOf(disparity)), std::invalid_argument);
}

}  // namespace
}  // namespace stereo_sgmp
