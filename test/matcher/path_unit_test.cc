#include "matcher/path_unit.h"

#include <gtest/gtest.h>

#include "stereo_sgmp/presets.h"

namespace stereo_sgmp {
namespace {

TEST(PathUnitTest, PresetsMatchInBytes) {
  EXPECT_EQ(PathUnit(PresetOptions("default"), false), 7);
  EXPECT_EQ(PathUnit(PresetOptions("quality"), false), 7);
  // 255 and P2 of 900 in 8 bits.
  EXPECT_EQ(PathUnit(PresetOptions("paper"), false), 5);
}

TEST(PathUnitTest, GivenCostsTakeTheSmallestUnitThatFits) {
  Options options;
  options.aggregation.p1 = 10;
  options.aggregation.alpha = 10.0;  // P2 of 110
  EXPECT_EQ(PathUnit(options, true), 2);
  EXPECT_EQ(PathUnit(options, false), 7) << "the only compact form of the mixed cost";
}

TEST(PathUnitTest, LargePenaltiesNeedFullCosts) {
  Options options;
  options.aggregation.p1 = 400;
  EXPECT_EQ(PathUnit(options, false), 1);
  options.aggregation.alpha = 16.0;
  EXPECT_EQ(PathUnit(options, true), 1);
}

TEST(PathUnitTest, FullCostsCanBeAskedFor) {
  Options options;
  options.aggregation.path_costs = PathCosts::kFull;
  EXPECT_EQ(PathUnit(options, false), 1);
  EXPECT_EQ(PathUnit(options, true), 1);
}

}  // namespace
}  // namespace stereo_sgmp
