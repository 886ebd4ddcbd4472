#include "refinement/validity.h"

#include <gtest/gtest.h>

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
    ThreadPool pool(2);
    cv::Mat disparity = disparity_;
    if (disparity.empty()) {
      map_.winner.convertTo(disparity, CV_32F, 1.0, map_.shape.min_disparity);
    }
    cv::Mat left_right;
    LeftRightDifferences(map_, &left_right, &pool);
    cv::Mat reason;
    FindInvalid(map_, left_right, disparity, confidence_, options_, &reason, &pool);
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

}  // namespace
}  // namespace stereo_sgmp
