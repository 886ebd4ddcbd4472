#include "cost/radiometric_fit.h"

#include <cstdint>

#include <gtest/gtest.h>

namespace stereo_sgmp {
namespace {

constexpr int kWidth = 200;
constexpr int kHeight = 120;
constexpr int kDisparity = 11;

struct Pair {
  cv::Mat left = cv::Mat(kHeight, kWidth, CV_8UC1);
  cv::Mat right = cv::Mat(kHeight, kWidth, CV_8UC1);
  cv::Mat disparity = cv::Mat(kHeight, kWidth, CV_32FC1, cv::Scalar(kDisparity));
  cv::Mat confident = cv::Mat(kHeight, kWidth, CV_8UC1, cv::Scalar(255));
};

// A pair with I_l = gain I_r + offset + noise.
Pair MakePair(double gain, double offset, double noise) {
  Pair pair;
  cv::RNG rng(1);
  rng.fill(pair.right, cv::RNG::UNIFORM, 20, 150);
  rng.fill(pair.left, cv::RNG::UNIFORM, 20, 150);
  for (int y = 0; y < kHeight; ++y) {
    for (int x = kDisparity; x < kWidth; ++x) {
      const double gray = pair.right.at<std::uint8_t>(y, x - kDisparity);
      const double mapped = gain * gray + offset + rng.gaussian(noise);
      pair.left.at<std::uint8_t>(y, x) = cv::saturate_cast<std::uint8_t>(mapped);
    }
  }
  return pair;
}

RadiometricFit Fit(const Pair& pair) {
  return RadiometricFitter().Fit(pair.left, pair.right, pair.disparity, pair.confident);
}

TEST(RadiometricFitTest, RecoversGainAndOffset) {
  const RadiometricFit fit = Fit(MakePair(1.3, -14.0, 1.0));
  EXPECT_NEAR(fit.gain, 1.3, 0.01);
  EXPECT_NEAR(fit.offset, -14.0, 1.0);
  EXPECT_EQ(fit.ad_weight, 1.0);
}

TEST(RadiometricFitTest, OutliersDoNotPullTheFit) {
  Pair pair = MakePair(0.8, 25.0, 1.0);
  cv::RNG rng(2);
  cv::Mat wrong = pair.left.rowRange(0, kHeight / 4);
  rng.fill(wrong, cv::RNG::UNIFORM, 0, 240);
  const RadiometricFit fit = Fit(pair);
  EXPECT_NEAR(fit.gain, 0.8, 0.02);
  EXPECT_NEAR(fit.offset, 25.0, 2.0);
}

TEST(RadiometricFitTest, IgnoresWhatIsNotConfident) {
  Pair pair = MakePair(1.2, 10.0, 0.5);
  pair.left.rowRange(0, kHeight * 3 / 4).setTo(0);
  pair.confident.rowRange(0, kHeight * 3 / 4).setTo(0);
  EXPECT_NEAR(Fit(pair).gain, 1.2, 0.01);
}

TEST(RadiometricFitTest, StaysTheIdentityWithoutGain) {
  const RadiometricFit fit = Fit(MakePair(1.0, 0.0, 2.0));
  EXPECT_EQ(fit.gain, 1.0);
  EXPECT_EQ(fit.offset, 0.0);
  EXPECT_EQ(fit.ad_weight, 1.0);
}

TEST(RadiometricFitTest, WeightFallsWithTheRemainingDeviation) {
  // The median absolute deviation of a normal distribution is 0.67 sigma.
  const double some = Fit(MakePair(1.0, 0.0, 5.5 / 0.6745)).ad_weight;
  EXPECT_GT(some, 0.3);
  EXPECT_LT(some, 0.7);
  EXPECT_EQ(Fit(MakePair(1.0, 0.0, 20.0)).ad_weight, 0.0);
}

TEST(RadiometricFitTest, TooFewMatchesGiveTheIdentity) {
  Pair pair = MakePair(1.5, 0.0, 0.0);
  pair.confident.setTo(0);
  const RadiometricFit fit = Fit(pair);
  EXPECT_EQ(fit.gain, 1.0);
  EXPECT_EQ(fit.offset, 0.0);
  EXPECT_EQ(fit.ad_weight, 1.0);
}

}  // namespace
}  // namespace stereo_sgmp
