#include "cost/ncc_cost.h"

#include <algorithm>
#include <cmath>

#include <gtest/gtest.h>

#include "cost_test_util.h"

namespace stereo_sgmp {
namespace {

void Compute(const cv::Mat& left, const cv::Mat& right, const VolumeShape& shape, double epsilon,
             bool vertical_tolerance, int unit, NccCost* cost) {
  ThreadPool pool(2);
  cost->Start(shape, epsilon, vertical_tolerance, unit);
  cost->PrepareRight(right, &pool);
  cost->PrepareLeft(left, &pool);
  cost->Complete(&pool);
}

// 25 times covariance and deviations of the 5x5 patches, with exact sums.
struct PatchSums {
  int l = 0, r = 0, ll = 0, rr = 0, lr = 0;
};

PatchSums Sums(const cv::Mat& left, const cv::Mat& right, int x, int y, int match, int match_y) {
  PatchSums s;
  for (int dy = -2; dy <= 2; ++dy) {
    for (int dx = -2; dx <= 2; ++dx) {
      const int l = Clamped(left, x + dx, y + dy);
      const int r = Clamped(right, match + dx, match_y + dy);
      s.l += l;
      s.r += r;
      s.ll += l * l;
      s.rr += r * r;
      s.lr += l * r;
    }
  }
  return s;
}

int ReferenceNcc(const cv::Mat& left, const cv::Mat& right, float epsilon, int x, int y, int match,
                 int match_y) {
  const PatchSums s = Sums(left, right, x, y, match, match_y);
  const float covariance = static_cast<float>(25 * s.lr - s.l * s.r);
  const float deviations = std::sqrt(static_cast<float>(25 * s.ll - s.l * s.l)) *
                           std::sqrt(static_cast<float>(25 * s.rr - s.r * s.r));
  const float ncc = std::max(0.0F, covariance / (deviations + 25.0F * epsilon));
  return static_cast<int>(std::lrint((1.0F - ncc) * 255.0F));
}

ReferenceCost Reference(const cv::Mat& left, const cv::Mat& right, float epsilon, int tolerance) {
  return [=](int x, int y, int match) {
    if (match < 0 || match >= right.cols) return 255;
    int best = 255;
    for (int dy = -tolerance; dy <= tolerance; ++dy) {
      if (y + dy < 0 || y + dy >= right.rows) continue;
      best = std::min(best, ReferenceNcc(left, right, epsilon, x, y, match, y + dy));
    }
    return best;
  };
}

TEST(NccCostTest, EqualsScalarReferenceOnAllTargets) {
  NccCost cost;
  for (const VolumeShape& shape : AwkwardShapes()) {
    const cv::Mat left = RandomGray(shape.width, shape.height, 1);
    const cv::Mat right = RandomGray(shape.width, shape.height, 2);
    const ExpectedCosts expected(shape, Reference(left, right, 1.0F, 0));
    ForEachTarget([&] {
      Compute(left, right, shape, 1.0, false, 1, &cost);
      ExpectCosts(cost, expected);
    });
  }
}

TEST(NccCostTest, VerticalToleranceTakesTheMinimumOfThreeRows) {
  NccCost cost;
  for (const VolumeShape& shape : {VolumeShape{1, 1, 4, -1}, VolumeShape{33, 2, 20, 0},
                                   VolumeShape{70, 9, 65, -4}, VolumeShape{65, 4, 300, -9}}) {
    const cv::Mat left = RandomGray(shape.width, shape.height, 3);
    const cv::Mat right = RandomGray(shape.width, shape.height, 4);
    const ExpectedCosts expected(shape, Reference(left, right, 1.0F, 1));
    ForEachTarget([&] {
      Compute(left, right, shape, 1.0, true, 1, &cost);
      ExpectCosts(cost, expected);
    });
  }
}

TEST(NccCostTest, CompactCostsAreTheFullOnesInUnits) {
  const VolumeShape shape{70, 5, 65, -4};
  const cv::Mat left = RandomGray(shape.width, shape.height, 3);
  const cv::Mat right = RandomGray(shape.width, shape.height, 4);
  NccCost cost;
  for (int unit = 2; unit <= 16; ++unit) {
    const ExpectedCosts expected(shape, InUnits(Reference(left, right, 1.0F, 1), unit));
    ForEachTarget([&] {
      Compute(left, right, shape, 1.0, true, unit, &cost);
      EXPECT_EQ(cost.unit(), unit);
      ExpectCosts(cost, expected);
    });
  }
}

TEST(NccCostTest, EpsilonIsAddedToTheDenominator) {
  const VolumeShape shape{60, 8, 30, 0};
  const cv::Mat left = RandomGray(shape.width, shape.height, 5) / 8;
  const cv::Mat right = RandomGray(shape.width, shape.height, 6) / 8;
  NccCost cost;
  Compute(left, right, shape, 50.0, false, 1, &cost);
  ExpectCosts(cost, Reference(left, right, 50.0F, 0));
}

// Cost of a pixel in the middle of `left` matched with the same place in `right`.
int CostOfSamePlace(const cv::Mat& left, const cv::Mat& right, double epsilon) {
  const VolumeShape shape{left.cols, left.rows, 1, 0};
  NccCost cost;
  Compute(left, right, shape, epsilon, false, 1, &cost);
  return cost.Row(left.rows / 2, left.cols / 2, left.cols / 2 + 1, nullptr)[0];
}

TEST(NccCostTest, IdenticalPatchesCostNothingWhateverTheGain) {
  const cv::Mat image = RandomGray(20, 20, 8) / 4;
  const cv::Mat brighter = image * 3 + 40;
  const cv::Mat inverted = 255 - image;
  EXPECT_EQ(CostOfSamePlace(image, image, 1.0), 0);
  EXPECT_EQ(CostOfSamePlace(image, brighter, 1.0), 0);
  EXPECT_EQ(CostOfSamePlace(image, inverted, 1.0), 255);
}

TEST(NccCostTest, FlatPatchesMatchNothingEvenWithoutEpsilon) {
  const cv::Mat flat(20, 20, CV_8UC1, cv::Scalar(90));
  EXPECT_EQ(CostOfSamePlace(flat, flat, 1.0), 255);
  EXPECT_EQ(CostOfSamePlace(flat, flat, 0.0), 255);
}

}  // namespace
}  // namespace stereo_sgmp
