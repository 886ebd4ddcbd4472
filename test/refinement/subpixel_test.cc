#include "refinement/subpixel.h"

#include <gtest/gtest.h>
#include <hwy/targets.h>

#include <algorithm>
#include <cmath>

#include "winner_maps.h"

namespace stereo_sgmp {
namespace {

// Disparity of one pixel that wins at index 5 of 10, min_disparity -3, with these three costs.
float DisparityOf(Subpixel method, std::uint16_t below, std::uint16_t cost, std::uint16_t above) {
  WinnerMap map = UniformWinnerMap({1, 1, 10, -3}, 5);
  map.cost_below(0, 0) = below;
  map.cost(0, 0) = cost;
  map.cost_above(0, 0) = above;
  ThreadPool pool(1);
  cv::Mat disparity;
  RefineSubpixel(map, method, &disparity, &pool);
  return disparity.at<float>(0, 0);
}

TEST(SubpixelTest, FormulasOnKnownCosts) {
  // Rises of 30 to the left and 10 to the right.
  EXPECT_FLOAT_EQ(DisparityOf(Subpixel::kNone, 130, 100, 110), 2.0f);
  EXPECT_FLOAT_EQ(DisparityOf(Subpixel::kEquiangular, 130, 100, 110), 2.0f + 20.0f / 60.0f);
  EXPECT_FLOAT_EQ(DisparityOf(Subpixel::kParabola, 130, 100, 110), 2.0f + 20.0f / 80.0f);
  EXPECT_FLOAT_EQ(DisparityOf(Subpixel::kBlend, 130, 100, 110), 2.0f + 7.0f / 24.0f);
}

TEST(SubpixelTest, IsOddInTheNeighbours) {
  for (const Subpixel method : {Subpixel::kEquiangular, Subpixel::kParabola, Subpixel::kBlend}) {
    const float right = DisparityOf(method, 170, 100, 120) - 2.0f;
    const float left = DisparityOf(method, 120, 100, 170) - 2.0f;
    EXPECT_GT(right, 0.0f);
    EXPECT_FLOAT_EQ(left, -right);
  }
}

TEST(SubpixelTest, EqualNeighbourPullsHalfWay) {
  for (const Subpixel method : {Subpixel::kEquiangular, Subpixel::kParabola, Subpixel::kBlend}) {
    EXPECT_FLOAT_EQ(DisparityOf(method, 180, 100, 100), 2.5f);
  }
}

TEST(SubpixelTest, FlatCostsAndRangeEndsStayAtTheWinner) {
  for (const Subpixel method : {Subpixel::kEquiangular, Subpixel::kParabola, Subpixel::kBlend}) {
    EXPECT_EQ(DisparityOf(method, 100, 100, 100), 2.0f);
    EXPECT_EQ(DisparityOf(method, WinnerMap::kNone, 100, 110), 2.0f);
    EXPECT_EQ(DisparityOf(method, 110, 100, WinnerMap::kNone), 2.0f);
    EXPECT_EQ(DisparityOf(method, WinnerMap::kNone, 100, WinnerMap::kNone), 2.0f);
  }
}

TEST(SubpixelTest, StaysWithinHalfAPixelAndDoesNotDependOnThreads) {
  const WinnerMap map = RandomWinnerMap({37, 11, 9, 4}, 1);
  ThreadPool one(1);
  ThreadPool three(3);
  cv::Mat expected;
  cv::Mat actual;
  RefineSubpixel(map, Subpixel::kBlend, &expected, &one);
  RefineSubpixel(map, Subpixel::kBlend, &actual, &three);
  EXPECT_EQ(cv::norm(expected, actual, cv::NORM_INF), 0.0);
  for (int y = 0; y < map.shape.height; ++y) {
    for (int x = 0; x < map.shape.width; ++x) {
      EXPECT_LE(std::abs(actual.at<float>(y, x) - 4.0f - map.winner(y, x)), 0.5f);
    }
  }
}

float ReferenceOffset(Subpixel method, float left, float right) {
  const float largest = 2.0F * std::max(left, right);
  const float equiangular = largest > 0.0F ? (left - right) / largest : 0.0F;
  const float sum = 2.0F * (left + right);
  const float parabola = sum > 0.0F ? (left - right) / sum : 0.0F;
  switch (method) {
    case Subpixel::kNone:
      return 0.0F;
    case Subpixel::kEquiangular:
      return equiangular;
    case Subpixel::kParabola:
      return parabola;
    case Subpixel::kBlend:
      return 0.5F * (equiangular + parabola);
  }
  return 0.0F;
}

TEST(SubpixelTest, EqualsTheDefinitionOnEveryTargetAndWidth) {
  ThreadPool pool(1);
  for (const int width : {1, 3, 8, 15, 16, 17, 40, 127}) {
    const WinnerMap map = RandomWinnerMap({width, 3, 6, -2}, static_cast<unsigned>(width));
    for (const Subpixel method :
         {Subpixel::kNone, Subpixel::kEquiangular, Subpixel::kParabola, Subpixel::kBlend}) {
      for (const auto target : hwy::SupportedAndGeneratedTargets()) {
        hwy::SetSupportedTargetsForTest(target);
        cv::Mat disparity;
        RefineSubpixel(map, method, &disparity, &pool);
        hwy::SetSupportedTargetsForTest(0);
        for (int y = 0; y < 3; ++y) {
          for (int x = 0; x < width; ++x) {
            const int cost = map.cost(y, x);
            const bool inside = map.winner(y, x) > 0 && map.winner(y, x) < 5;
            const float offset =
                inside ? ReferenceOffset(method, static_cast<float>(map.cost_below(y, x) - cost),
                                         static_cast<float>(map.cost_above(y, x) - cost))
                       : 0.0F;
            ASSERT_EQ(disparity.at<float>(y, x),
                      -2.0F + static_cast<float>(map.winner(y, x)) + offset)
                << hwy::TargetName(target) << " at " << x << " of " << width;
          }
        }
      }
    }
  }
}

}  // namespace
}  // namespace stereo_sgmp
