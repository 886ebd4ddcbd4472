#include "matcher/coarse_pass.h"

#include <gtest/gtest.h>

namespace stereo_sgmp {
namespace {

Options WithFactor(int factor) {
  Options options;
  options.num_disparities = 256;
  options.prior.coarse_factor = factor;
  return options;
}

TEST(CoarsePassTest, AutomaticFactorIsThatOfThePaperForLargeImages) {
  const Options automatic = WithFactor(0);
  EXPECT_EQ(CoarsePass::Shape(automatic, {6000, 4000}).width, 1500);  // never less than a quarter
  EXPECT_EQ(CoarsePass::Shape(automatic, {2880, 1988}).width, 720);
  EXPECT_EQ(CoarsePass::Shape(automatic, {1440, 994}).width, 360);
  EXPECT_EQ(CoarsePass::Shape(automatic, {1200, 900}).width, 400);  // 0.12 megapixels
  EXPECT_EQ(CoarsePass::Shape(automatic, {640, 480}).width, 320);
  EXPECT_EQ(CoarsePass::Shape(automatic, {1, 1}).width, 1);
}

TEST(CoarsePassTest, TheCoarseRangeCoversTheFullOne) {
  for (const int min_disparity : {-37, 0, 5, 64}) {
    for (const int factor : {1, 3, 4, 16}) {
      Options options = WithFactor(factor);
      options.min_disparity = min_disparity;
      const VolumeShape shape = CoarsePass::Shape(options, {641, 479});
      const double ratio = static_cast<double>(shape.width) / 641;
      EXPECT_LE(shape.min_disparity, min_disparity * ratio);
      // Less than one coarse disparity of it may be left out.
      EXPECT_GT(shape.min_disparity + shape.disparities, (min_disparity + 255) * ratio);
      EXPECT_LE(shape.min_disparity + shape.disparities - 1, (min_disparity + 255) * ratio);
    }
  }
}

}  // namespace
}  // namespace stereo_sgmp
