#include "cost/mixed_cost.h"

#include <cmath>
#include <cstdlib>

#include <gtest/gtest.h>
#include <opencv2/imgproc.hpp>

#include "cost_test_util.h"

namespace stereo_sgmp {
namespace {

void Prepare(const cv::Mat& left, const cv::Mat& right, const VolumeShape& shape,
             const RadiometricFit& fit, int unit, MixedCost* cost) {
  ThreadPool pool(2);
  cost->Start(shape, fit, unit);
  cost->PrepareRight(right, &pool);
  cost->PrepareLeft(left, &pool);
}

int Weighted(double gray, double weight) {
  return cv::saturate_cast<std::uint8_t>(weight * std::clamp(gray, 0.0, 255.0));
}

int GradientDifference(const cv::Mat& left, const cv::Mat& right, int x, int y, int match, int dx,
                       int dy) {
  const auto gradient = [&](const cv::Mat& image, int column) {
    const int difference =
        Clamped(image, column + dx, y + dy) - Clamped(image, column - dx, y - dy);
    return std::clamp(difference, -128, 127);
  };
  return std::abs(gradient(left, x) - gradient(right, match));
}

ReferenceCost Reference(const cv::Mat& left, const cv::Mat& right, const RadiometricFit& fit,
                        int unit) {
  return [=](int x, int y, int match) {
    const bool full = unit == 1;
    if (match < 0 || match >= right.cols) return full ? 188 : 26;
    const int h = ReferenceHamming(left, right, 3, 2, x, y, match);
    const int l = Weighted(Clamped(left, x, y), fit.ad_weight);
    const int r = Weighted(fit.gain * Clamped(right, match, y) + fit.offset, fit.ad_weight);
    const int limit = static_cast<int>(std::lrint(30.0 * fit.ad_weight));
    const int ad = std::min(limit, std::abs(l - r));
    const int g = std::min(10, GradientDifference(left, right, x, y, match, 1, 0) +
                                   GradientDifference(left, right, x, y, match, 0, 1));
    return full ? std::min(255, 7 * h + (h >> 2) + ad + 10 * g)
                : std::min(36, h + g + (ad + 3 * g + 7) / 8);
  };
}

class MixedCostTest : public testing::TestWithParam<int> {};

INSTANTIATE_TEST_SUITE_P(Units, MixedCostTest, testing::Values(1, 7));

TEST_P(MixedCostTest, EqualsScalarReferenceOnAllTargets) {
  const int unit = GetParam();
  MixedCost cost;
  for (const VolumeShape& shape : AwkwardShapes()) {
    const cv::Mat left = RandomGray(shape.width, shape.height, 1);
    const cv::Mat right = RandomGray(shape.width, shape.height, 2);
    const ExpectedCosts expected(shape, Reference(left, right, RadiometricFit(), unit));
    ForEachTarget([&] {
      Prepare(left, right, shape, RadiometricFit(), unit, &cost);
      EXPECT_EQ(cost.unit(), unit);
      ExpectCosts(cost, expected);
    });
  }
}

TEST_P(MixedCostTest, SmoothImagesReachTheLowCosts) {
  const int unit = GetParam();
  const VolumeShape shape{70, 20, 40, -3};
  cv::Mat left = RandomGray(shape.width, shape.height, 3);
  cv::GaussianBlur(left, left, cv::Size(), 4.0);
  cv::Mat right = RandomGray(shape.width, shape.height, 4);
  cv::GaussianBlur(right, right, cv::Size(), 4.0);
  MixedCost cost;
  const ExpectedCosts expected(shape, Reference(left, right, RadiometricFit(), unit));
  ForEachTarget([&] {
    Prepare(left, right, shape, RadiometricFit(), unit, &cost);
    ExpectCosts(cost, expected);
  });
}

TEST_P(MixedCostTest, AppliesGainOffsetAndWeightToTheAbsoluteDifference) {
  const VolumeShape shape{70, 9, 33, 0};
  const cv::Mat left = RandomGray(shape.width, shape.height, 5);
  const cv::Mat right = RandomGray(shape.width, shape.height, 6);
  MixedCost cost;
  for (const RadiometricFit& fit :
       {RadiometricFit{1.3, -20.0, 1.0}, RadiometricFit{0.7, 12.5, 0.4}, {1.0, 0.0, 0.0}}) {
    Prepare(left, right, shape, fit, GetParam(), &cost);
    ExpectCosts(cost, Reference(left, right, fit, GetParam()));
  }
}

TEST_P(MixedCostTest, SamePixelCostsNothing) {
  const VolumeShape shape{40, 8, 16, 0};
  const cv::Mat image = RandomGray(shape.width, shape.height, 7);
  MixedCost cost;
  Prepare(image, image, shape, RadiometricFit(), GetParam(), &cost);
  AlignedBuffer<std::uint8_t> scratch;
  scratch.Resize(static_cast<std::size_t>(shape.width * shape.Stride()));
  const std::uint8_t* row = cost.Row(3, 0, shape.width, scratch.data());
  for (int x = 0; x < shape.width; ++x) EXPECT_EQ(row[x * shape.Stride()], 0);
}

}  // namespace
}  // namespace stereo_sgmp
