#include "refinement/validity.h"

#include <gtest/gtest.h>
#include <hwy/targets.h>

#include <cmath>
#include <cstdint>
#include <random>

#include "refinement/left_right.h"
#include "stereo_sgmp/match_result.h"
#include "winner_maps.h"

namespace stereo_sgmp {
namespace {

constexpr int kColumn = 30;  // of the pixel that the tests look at
const VolumeShape kShape = {60, 1, 20, -2};
constexpr std::uint16_t kWinner = 7;
constexpr int kMatch = kColumn - 5;  // disparity 7 - 2

class ValidityTest : public testing::Test {
 protected:
  ValidityTest() {
    options_.min_confidence = 0.3;
    options_.lr_tolerance = 1.0;
    options_.uniqueness_ratio = 0.0;
  }

  InvalidReason ReasonAt(int x) {
    cv::Mat disparity = disparity_;
    if (disparity.empty()) {
      map_.winner.convertTo(disparity, CV_32F, 1.0, map_.shape.min_disparity);
    }
    cv::Mat left_right(disparity.size(), CV_16U);
    LeftRightDifferences(map_, 0, 1, &left_right);
    cv::Mat reason(disparity.size(), CV_8U);
    FindInvalid(map_, left_right, disparity, confidence_, options_, 0, 1, &reason);
    return static_cast<InvalidReason>(reason.at<std::uint8_t>(0, x));
  }
  InvalidReason Reason() { return ReasonAt(kColumn); }

  WinnerMap map_ = UniformWinnerMap(kShape, kWinner);
  cv::Mat disparity_;  // that of the winners where it is empty
  cv::Mat confidence_ = cv::Mat(1, kShape.width, CV_32F, cv::Scalar(0.9));
  FilterOptions options_;
};

TEST_F(ValidityTest, ClearWinnersAreValid) { EXPECT_EQ(Reason(), InvalidReason::kValid); }

TEST_F(ValidityTest, RangeEnds) {
  map_.winner(0, kColumn) = 0;
  EXPECT_EQ(Reason(), InvalidReason::kRange);
  map_.winner(0, kColumn) = 19;
  EXPECT_EQ(Reason(), InvalidReason::kRange);
}

TEST_F(ValidityTest, TwoDisparitiesHaveNoRangeEnds) {
  map_ = UniformWinnerMap({60, 1, 2, -2}, 1);
  EXPECT_EQ(Reason(), InvalidReason::kValid);
  map_ = UniformWinnerMap({60, 1, 3, -2}, 2);
  EXPECT_EQ(Reason(), InvalidReason::kRange);
}

TEST_F(ValidityTest, MatchesOutsideTheRightImage) {
  EXPECT_EQ(ReasonAt(4), InvalidReason::kBorder);
  EXPECT_EQ(ReasonAt(5), InvalidReason::kValid);
  map_ = UniformWinnerMap(kShape, 1);  // disparity -1
  EXPECT_EQ(ReasonAt(59), InvalidReason::kBorder);
  EXPECT_EQ(ReasonAt(58), InvalidReason::kValid);
}

TEST_F(ValidityTest, LowConfidence) {
  confidence_.at<float>(0, kColumn) = 0.29f;
  EXPECT_EQ(Reason(), InvalidReason::kUncertainty);
  options_.min_confidence = 0.0;
  EXPECT_EQ(Reason(), InvalidReason::kValid);
}

TEST_F(ValidityTest, AMendedDisparityIsComparedInPlaceOfTheWinner) {
  map_.winner.convertTo(disparity_, CV_32F, 1.0, map_.shape.min_disparity);
  map_.winner(0, kColumn) = kWinner + 2;
  EXPECT_EQ(Reason(), InvalidReason::kValid);
  map_.winner(0, kColumn) = kWinner + 3;  // further off than smoothing mends
  EXPECT_EQ(Reason(), InvalidReason::kLeftRight);
  map_.winner(0, kColumn) = kWinner + 2;
  disparity_.at<float>(0, kColumn) += 1.2F;  // the right image says 5
  EXPECT_EQ(Reason(), InvalidReason::kLeftRight);
  options_.lr_tolerance = 1.25;
  EXPECT_EQ(Reason(), InvalidReason::kValid);
}

TEST_F(ValidityTest, LeftRightWithinTolerance) {
  map_.right_winner(0, kMatch) = kWinner + 1;
  EXPECT_EQ(Reason(), InvalidReason::kValid);
  map_.right_winner(0, kMatch) = kWinner - 2;
  EXPECT_EQ(Reason(), InvalidReason::kLeftRight);
  options_.lr_tolerance = 2.0;
  EXPECT_EQ(Reason(), InvalidReason::kValid);
  map_.right_winner(0, kMatch) = WinnerMap::kNone;
  EXPECT_EQ(Reason(), InvalidReason::kLeftRight);
  options_.lr_tolerance = -1.0;
  EXPECT_EQ(Reason(), InvalidReason::kValid);
}

TEST_F(ValidityTest, UniquenessAsStereoSgbmMeansIt) {
  map_.cost(0, kColumn) = 90;
  map_.second(0, kColumn) = 100;
  options_.uniqueness_ratio = 10.0;  // the best is lower by exactly that
  EXPECT_EQ(Reason(), InvalidReason::kValid);
  options_.uniqueness_ratio = 11.0;
  EXPECT_EQ(Reason(), InvalidReason::kUniqueness);
  map_.second(0, kColumn) = WinnerMap::kNone;
  EXPECT_EQ(Reason(), InvalidReason::kValid);
}

TEST_F(ValidityTest, UniquenessOfZeroIsOff) {
  map_.second(0, kColumn) = map_.cost(0, kColumn);
  EXPECT_EQ(Reason(), InvalidReason::kValid);
}

TEST_F(ValidityTest, FirstReasonInTheOrderOfTheEnumIsGiven) {
  options_.uniqueness_ratio = 50.0;
  map_.second(0, kColumn) = 101;
  EXPECT_EQ(Reason(), InvalidReason::kUniqueness);
  map_.right_winner(0, kMatch) = 0;
  EXPECT_EQ(Reason(), InvalidReason::kLeftRight);
  confidence_.at<float>(0, kColumn) = 0.0f;
  EXPECT_EQ(Reason(), InvalidReason::kUncertainty);
  map_.winner(0, kColumn) = 19;
  EXPECT_EQ(Reason(), InvalidReason::kRange);
  map_.winner(0, 3) = 18;
  confidence_.at<float>(0, 3) = 0.0f;
  EXPECT_EQ(ReasonAt(3), InvalidReason::kBorder);
}

// The reasons as they are defined, one pixel at a time.
InvalidReason ReferenceReason(const WinnerMap& map, const cv::Mat& left_right,
                              const cv::Mat& disparities, const cv::Mat& confidence,
                              const FilterOptions& options, int y, int x) {
  const VolumeShape& shape = map.shape;
  const int winner = map.winner(y, x);
  const bool is_end = winner == 0 || winner == shape.disparities - 1;
  if (shape.disparities > 2 && is_end) return InvalidReason::kRange;
  const int border = x - shape.min_disparity - winner;
  if (border < 0 || border >= shape.width) return InvalidReason::kBorder;
  if (confidence.at<float>(y, x) < options.min_confidence) return InvalidReason::kUncertainty;
  if (options.lr_tolerance < 0.0) return InvalidReason::kValid;
  const float disparity = disparities.at<float>(y, x);
  const int match = x - static_cast<int>(std::lround(disparity));
  if (match < 0 || match >= shape.width) return InvalidReason::kLeftRight;
  const int right = map.right_winner(y, match);
  const double apart = std::abs(right + shape.min_disparity - static_cast<double>(disparity));
  const bool disagree = right == WinnerMap::kNone || apart > options.lr_tolerance ||
                        left_right.at<std::uint16_t>(y, x) > 2.0 * options.lr_tolerance;
  return disagree ? InvalidReason::kLeftRight : InvalidReason::kValid;
}

// Disparities that are whole, halves, next to halves, or anything in between, most of them near
// the winner.
cv::Mat NearbyDisparities(const WinnerMap& map, std::mt19937* random) {
  cv::Mat disparities(map.winner.size(), CV_32F);
  const float offsets[] = {0.0F, 0.5F, -0.5F, 1.5F, 0.3F, -1.5F, 0.1F, 7.25F};
  for (int y = 0; y < disparities.rows; ++y) {
    for (int x = 0; x < disparities.cols; ++x) {
      const float value =
          static_cast<float>(map.winner(y, x) + map.shape.min_disparity) + offsets[(*random)() % 8];
      const float next = (*random)() % 2 == 0 ? -1000.0F : 1000.0F;
      disparities.at<float>(y, x) = (*random)() % 2 == 0 ? value : std::nextafter(value, next);
    }
  }
  return disparities;
}

TEST(ValidityKernelTest, EqualsTheDefinitionOnEveryTargetAndWidth) {
  std::mt19937 random(3);
  for (const VolumeShape& shape : {VolumeShape{1, 3, 4, 0},
                                   {7, 5, 2, -1},
                                   {16, 4, 3, 0},
                                   {33, 3, 9, -5},
                                   {530, 2, 40, 3},
                                   {1030, 2, 64, 0}}) {
    WinnerMap map = RandomWinnerMap(shape, 3);
    const cv::Mat disparities = NearbyDisparities(map, &random);
    cv::Mat confidence(map.winner.size(), CV_32F);
    cv::randu(confidence, 0, 1);
    cv::Mat left_right(map.winner.size(), CV_16U);
    LeftRightDifferences(map, 0, shape.height, &left_right);
    FilterOptions options;
    for (const double tolerance : {-1.0, 0.0, 0.1, 0.5, 1.0, 1.5, 1.7, 1e9}) {
      options.lr_tolerance = tolerance;
      options.min_confidence = confidence.at<float>(0, 0) + (tolerance > 1.0 ? 1e-12 : 0.0);
      for (const auto target : hwy::SupportedAndGeneratedTargets()) {
        hwy::SetSupportedTargetsForTest(target);
        cv::Mat reason(map.winner.size(), CV_8U);
        FindInvalid(map, left_right, disparities, confidence, options, 0, shape.height, &reason);
        hwy::SetSupportedTargetsForTest(0);
        for (int y = 0; y < shape.height; ++y) {
          for (int x = 0; x < shape.width; ++x) {
            const InvalidReason expected =
                ReferenceReason(map, left_right, disparities, confidence, options, y, x);
            ASSERT_EQ(reason.at<std::uint8_t>(y, x), static_cast<std::uint8_t>(expected))
                << hwy::TargetName(target) << " " << tolerance << " at " << x << " " << y << " of "
                << shape.width;
          }
        }
      }
    }
  }
}

}  // namespace
}  // namespace stereo_sgmp
