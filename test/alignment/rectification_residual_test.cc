#include "alignment/rectification_residual.h"

#include <algorithm>
#include <cmath>
#include <vector>

#include <gtest/gtest.h>

#include "textured_pair.h"

namespace stereo_sgmp {
namespace {

const cv::Size kSize(360, 280);

void ExpectModel(const ResidualFit& fit, double a, double b, int height, double tolerance) {
  EXPECT_TRUE(fit.reliable);
  for (int y = 0; y < height; ++y) {
    ASSERT_NEAR(fit.a * y + fit.b, a * y + b, tolerance) << "at row " << y;
  }
}

struct Model {
  double a;
  double b;
};

class ResidualModelTest : public testing::TestWithParam<Model> {};

TEST_P(ResidualModelTest, IsRecoveredOnAllRows) {
  const auto [a, b] = GetParam();
  const TexturedPair pair = MakePair(kSize, 17.4, a, b);
  const ResidualFit fit = FitRectificationResidual(pair.left, pair.right, 0, 48);
  ExpectModel(fit, a, b, kSize.height, 0.05);
  EXPECT_LT(fit.residual, 0.1);
  const double last = kSize.height - 1;
  EXPECT_NEAR(fit.max_shift, std::max(std::abs(b), std::abs((a - 1.0) * last + b)), 0.05);
}

INSTANTIATE_TEST_SUITE_P(Models, ResidualModelTest,
                         testing::Values(Model{1.0, 0.0}, Model{1.0, 0.7}, Model{1.004, -0.8},
                                         Model{0.99, 3.3}, Model{1.0, -7.2}));

TEST(RectificationResidualTest, BearsNegativeDisparitiesAndExposureDifferences) {
  const TexturedPair pair = MakePair(kSize, -9.0, 1.002, 0.4, 0.7);
  ExpectModel(FitRectificationResidual(pair.left, pair.right, -20, 40), 1.002, 0.4, kSize.height,
              0.05);
}

TEST(RectificationResidualTest, SearchesLargeImagesAtLowerScale) {
  const cv::Size size(1000, 700);
  const TexturedPair pair = MakePair(size, 45.3, 1.003, -1.4);
  ExpectModel(FitRectificationResidual(pair.left, pair.right, 0, 128), 1.003, -1.4, size.height,
              0.05);
}

TEST(RectificationResidualTest, IsTheSameEveryTime) {
  const TexturedPair pair = MakePair(kSize, 11.0, 1.001, 0.5);
  const ResidualFit first = FitRectificationResidual(pair.left, pair.right, 0, 32);
  const ResidualFit second = FitRectificationResidual(pair.left, pair.right, 0, 32);
  EXPECT_EQ(first.a, second.a);
  EXPECT_EQ(first.b, second.b);
  EXPECT_EQ(first.inliers, second.inliers);
}

TEST(RectificationResidualTest, WithoutTextureIsTheIdentity) {
  for (const cv::Size size : {cv::Size(1, 1), cv::Size(1, 300), cv::Size(11, 11), cv::Size(12, 3),
                              cv::Size(40, 40), cv::Size(300, 200)}) {
    const cv::Mat flat(size, CV_8UC1, cv::Scalar(120));
    const ResidualFit fit = FitRectificationResidual(flat, flat, 0, 64);
    EXPECT_FALSE(fit.reliable);
    EXPECT_EQ(fit.a, 1.0);
    EXPECT_EQ(fit.b, 0.0);
  }
}

TEST(RectificationResidualTest, UnrelatedImagesAreNotReliable) {
  const TexturedPair one = MakePair(kSize, 0.0, 1.0, 0.0, 1.0, 5);
  const TexturedPair other = MakePair(kSize, 0.0, 1.0, 0.0, 1.0, 6);
  EXPECT_FALSE(FitRectificationResidual(one.left, other.right, 0, 64).reliable);
}

// `good` matches on y' = 1.002 y - 0.6 with a little noise over the rows [begin, end), and `bad`
// ones anywhere.
std::vector<RowMatch> NoisyMatches(int good, int bad, double begin, double end) {
  cv::RNG rng(3);
  std::vector<RowMatch> matches;
  for (int i = 0; i < good; ++i) {
    const double y = rng.uniform(begin, end);
    matches.push_back({y, 1.002 * y - 0.6 + rng.gaussian(0.05)});
  }
  for (int i = 0; i < bad; ++i) {
    const double y = rng.uniform(0.0, 480.0);
    matches.push_back({y, y + rng.uniform(-8.0, 8.0)});
  }
  return matches;
}

TEST(FitRowsTest, OutliersDoNotPullTheFit) {
  const ResidualFit fit = FitRows(NoisyMatches(200, 180, 0.0, 480.0), 480);
  ExpectModel(fit, 1.002, -0.6, 480, 0.05);
  EXPECT_GE(fit.inliers, 200);
  EXPECT_NEAR(fit.residual, 0.05 * 0.67, 0.03);
}

TEST(FitRowsTest, ReportsTheMedianOffset) {
  std::vector<RowMatch> matches;
  for (int y = 0; y < 480; ++y) matches.push_back({1.0 * y, y - 1.5});
  EXPECT_DOUBLE_EQ(FitRows(matches, 480).median_offset, 1.5);
}

TEST(FitRowsTest, NeedsInliersOnManyRows) {
  EXPECT_TRUE(FitRows(NoisyMatches(100, 10, 0.0, 480.0), 480).reliable);
  EXPECT_FALSE(FitRows(NoisyMatches(100, 10, 0.0, 120.0), 480).reliable);
  EXPECT_FALSE(FitRows(NoisyMatches(20, 0, 0.0, 480.0), 480).reliable);
  EXPECT_FALSE(FitRows(NoisyMatches(60, 400, 0.0, 480.0), 480).reliable);
  EXPECT_FALSE(FitRows({}, 480).reliable);
  EXPECT_FALSE(FitRows({{3.0, 3.0}}, 480).reliable);
}

}  // namespace
}  // namespace stereo_sgmp
