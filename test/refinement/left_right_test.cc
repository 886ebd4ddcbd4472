#include "refinement/left_right.h"

#include <gtest/gtest.h>
#include <hwy/targets.h>

#include <cstdint>
#include <cstdlib>

#include "winner_maps.h"

namespace stereo_sgmp {
namespace {

int ReferenceDifference(const WinnerMap& map, int y, int x) {
  const int match = x - map.shape.min_disparity - map.winner(y, x);
  if (match < 0 || match >= map.shape.width) return WinnerMap::kNone;
  const int right = map.right_winner(y, match);
  return right == WinnerMap::kNone ? right : std::abs(right - map.winner(y, x));
}

TEST(LeftRightTest, EqualsTheDefinitionOnEveryTargetAndWidth) {
  for (const VolumeShape& shape : {VolumeShape{1, 2, 3, 0},
                                   {5, 3, 4, -2},
                                   {16, 2, 9, 0},
                                   {47, 3, 20, 30},
                                   {520, 2, 50, -9},
                                   {1100, 1, 256, 0}}) {
    const WinnerMap map = RandomWinnerMap(shape, 5);
    for (const auto target : hwy::SupportedAndGeneratedTargets()) {
      hwy::SetSupportedTargetsForTest(target);
      cv::Mat difference(map.winner.size(), CV_16U);
      LeftRightDifferences(map, 0, shape.height, &difference);
      hwy::SetSupportedTargetsForTest(0);
      for (int y = 0; y < shape.height; ++y) {
        for (int x = 0; x < shape.width; ++x) {
          ASSERT_EQ(difference.at<std::uint16_t>(y, x), ReferenceDifference(map, y, x))
              << hwy::TargetName(target) << " at " << x << " " << y << " of " << shape.width;
        }
      }
    }
  }
}

TEST(LeftRightTest, MaskHoldsWhatIsNearerThanTheWorst) {
  const cv::Mat difference = (cv::Mat_<std::uint16_t>(2, 3) << 0, 1, 2, 3, WinnerMap::kNone, 1);
  cv::Mat mask(difference.size(), CV_8U, cv::Scalar(7));
  LeftRightMask(difference, 2, 1, 2, &mask);
  const cv::Mat expected = (cv::Mat_<std::uint8_t>(2, 3) << 7, 7, 7, 0, 0, 255);
  EXPECT_EQ(cv::norm(mask, expected, cv::NORM_INF), 0.0);
}

}  // namespace
}  // namespace stereo_sgmp
