#include "prior/convex_hulls.h"

#include <algorithm>
#include <cstdint>
#include <vector>

#include <gtest/gtest.h>

namespace stereo_sgmp {
namespace {

PlaneMap Empty(int planes, cv::Size size) {
  PlaneMap map;
  map.planes.resize(static_cast<std::size_t>(planes));
  map.labels = cv::Mat(size, CV_16SC1, cv::Scalar(-1));
  return map;
}

std::vector<int> PlanesAt(const ConvexHulls& hulls, int x, int y) {
  const PlaneSets& sets = hulls.sets();
  const PlaneSet& set = sets.sets[sets.ids.at<std::uint16_t>(y, x)];
  return {set.planes.begin(), set.planes.begin() + set.count};
}

TEST(ConvexHulls, FillsBetweenThePixelsOfAPlane) {
  PlaneMap map = Empty(1, {30, 30});
  for (const cv::Point corner : {cv::Point(5, 5), cv::Point(25, 5), cv::Point(15, 25)}) {
    map.labels.at<std::int16_t>(corner) = 0;
  }
  ConvexHulls hulls;
  hulls.Build(map);
  EXPECT_EQ(PlanesAt(hulls, 15, 12), (std::vector<int>{0}));
  EXPECT_EQ(PlanesAt(hulls, 5, 5), (std::vector<int>{0}));
  EXPECT_TRUE(PlanesAt(hulls, 6, 20).empty());
  EXPECT_TRUE(PlanesAt(hulls, 15, 27).empty());
}

TEST(ConvexHulls, OverlapHoldsBothPlanesLargestFirst) {
  PlaneMap map = Empty(2, {40, 20});
  map.labels(cv::Rect(0, 0, 10, 20)).setTo(0);
  map.labels(cv::Rect(30, 0, 10, 20)).setTo(0);
  map.labels(cv::Rect(15, 5, 8, 8)).setTo(1);
  ConvexHulls hulls;
  hulls.Build(map);
  EXPECT_EQ(PlanesAt(hulls, 18, 8), (std::vector<int>{0, 1}));
  EXPECT_EQ(PlanesAt(hulls, 28, 8), (std::vector<int>{0}));
  EXPECT_EQ(hulls.sets().sets.size(), 3U);
}

TEST(ConvexHulls, KeepsTheLargestWhereTooManyOverlap) {
  constexpr int kPlanes = PlaneSet::kMaxFound + 3;
  PlaneMap map = Empty(kPlanes, {2 * kPlanes + 1, 3});
  for (int i = 0; i < kPlanes; ++i) {
    map.labels.at<std::int16_t>(1, i) = static_cast<std::int16_t>(i);
    map.labels.at<std::int16_t>(1, 2 * kPlanes - i) = static_cast<std::int16_t>(i);
  }
  ConvexHulls hulls;
  hulls.Build(map);
  const std::vector<int> middle = PlanesAt(hulls, kPlanes, 1);
  ASSERT_EQ(middle.size(), static_cast<std::size_t>(PlaneSet::kMaxFound));
  for (std::size_t k = 0; k < middle.size(); ++k) EXPECT_EQ(middle[k], static_cast<int>(k));
}

TEST(ConvexHulls, EveryLabelPixelHoldsItsPlane) {
  PlaneMap map = Empty(6, {50, 35});
  cv::theRNG().state = 3;
  cv::randu(map.labels, -1, 6);
  ConvexHulls hulls;
  for (int repeat = 0; repeat < 2; ++repeat) {
    hulls.Build(map);
    for (int y = 0; y < 35; ++y) {
      for (int x = 0; x < 50; ++x) {
        const int label = map.labels.at<std::int16_t>(y, x);
        const std::vector<int> planes = PlanesAt(hulls, x, y);
        EXPECT_TRUE(label < 0 || std::count(planes.begin(), planes.end(), label) == 1);
      }
    }
  }
}

TEST(ConvexHulls, NoPlanesGiveTheEmptySetEverywhere) {
  ConvexHulls hulls;
  hulls.Build(Empty(0, {1, 9}));
  EXPECT_EQ(hulls.sets().sets.size(), 1U);
  EXPECT_EQ(cv::countNonZero(hulls.sets().ids), 0);
}

}  // namespace
}  // namespace stereo_sgmp
