#include "cost/volume_cost.h"

#include <string>

#include <gtest/gtest.h>

#include "cost_test_util.h"
#include "io/expect_message.h"

namespace stereo_sgmp {
namespace {

CostVolume Volume(const VolumeShape& shape) {
  CostVolume volume;
  volume.width = shape.width;
  volume.height = shape.height;
  volume.disparities = shape.disparities;
  volume.min_disparity = shape.min_disparity;
  for (int i = 0; i < shape.width * shape.height * shape.disparities; ++i) {
    volume.costs.push_back(static_cast<std::uint8_t>(i));
  }
  return volume;
}

TEST(VolumeCostTest, GivesTheCostsOfTheVolume) {
  for (const VolumeShape& shape :
       {VolumeShape{9, 4, 1, 0}, VolumeShape{17, 5, 64, -3}, VolumeShape{41, 3, 65, 7}}) {
    const CostVolume volume = Volume(shape);
    ExpectCosts(VolumeCost(volume, shape, 1), [&](int x, int y, int match) {
      return volume.At(y, x)[x - shape.min_disparity - match];
    });
  }
}

TEST(VolumeCostTest, CompactCostsAreTheFullOnesInUnits) {
  const VolumeShape shape{17, 5, 65, -3};
  const CostVolume volume = Volume(shape);
  const ReferenceCost full = [&](int x, int y, int match) {
    return volume.At(y, x)[x - shape.min_disparity - match];
  };
  for (int unit = 2; unit <= 16; ++unit) {
    ForEachTarget([&] {
      const VolumeCost cost(volume, shape, unit);
      EXPECT_EQ(cost.unit(), unit);
      ExpectCosts(cost, InUnits(full, unit));
    });
  }
}

TEST(VolumeCostTest, SaysWhatToSetWhereTheShapeIsAnother) {
  const VolumeShape wanted{9, 4, 32, 2};
  const auto expect = [&](const VolumeShape& found, const std::string& message) {
    ExpectInvalid([&] { VolumeCost(Volume(found), wanted, 1); }, message);
  };
  expect({8, 4, 32, 2}, "8 x 4 pixels, but the images have 9 x 4");
  expect({9, 5, 32, 2}, "9 x 5 pixels, but the images have 9 x 4");
  expect({9, 4, 31, 2}, "set num_disparities to 31");
  expect({9, 4, 32, 0}, "set min_disparity to 0");
  CostVolume short_of_one = Volume(wanted);
  short_of_one.costs.pop_back();
  ExpectInvalid([&] { VolumeCost(Volume(wanted), wanted, 0); }, "unit of the matching cost is 0");
  ExpectInvalid([&] { VolumeCost(short_of_one, wanted, 1); }, "holds 1151 costs");
}

}  // namespace
}  // namespace stereo_sgmp
