#include "cost/census_cost.h"

#include <gtest/gtest.h>

#include "cost_test_util.h"

namespace stereo_sgmp {
namespace {

void Prepare(const cv::Mat& left, const cv::Mat& right, const VolumeShape& shape,
             CensusWindow window, int unit, CensusCost* cost) {
  ThreadPool pool(2);
  cost->Start(shape, window, unit);
  cost->PrepareRight(right, &pool);
  cost->PrepareLeft(left, &pool);
}

struct Window {
  CensusWindow window;
  int radius_x;
  int radius_y;
  int scale;
  int outside;
};

class CensusCostTest : public testing::TestWithParam<Window> {};

ReferenceCost Reference(const Window& window, const cv::Mat& left, const cv::Mat& right) {
  return [=](int x, int y, int match) {
    if (match < 0 || match >= right.cols) return window.outside;
    return window.scale *
           ReferenceHamming(left, right, window.radius_x, window.radius_y, x, y, match);
  };
}

TEST_P(CensusCostTest, EqualsScalarReferenceOnAllTargets) {
  const Window& window = GetParam();
  CensusCost cost;
  for (const VolumeShape& shape : AwkwardShapes()) {
    const cv::Mat left = RandomGray(shape.width, shape.height, 1);
    const cv::Mat right = RandomGray(shape.width, shape.height, 2);
    const ExpectedCosts expected(shape, Reference(window, left, right));
    ForEachTarget([&] {
      Prepare(left, right, shape, window.window, 1, &cost);
      ExpectCosts(cost, expected);
    });
  }
}

TEST_P(CensusCostTest, CompactCostsAreTheFullOnesInUnits) {
  const Window& window = GetParam();
  const VolumeShape shape{70, 9, 65, -4};
  const cv::Mat left = RandomGray(shape.width, shape.height, 3);
  const cv::Mat right = RandomGray(shape.width, shape.height, 4);
  CensusCost cost;
  for (int unit = 2; unit <= 16; ++unit) {
    const ExpectedCosts expected(shape, InUnits(Reference(window, left, right), unit));
    ForEachTarget([&] {
      Prepare(left, right, shape, window.window, unit, &cost);
      EXPECT_EQ(cost.unit(), unit);
      ExpectCosts(cost, expected);
    });
  }
}

INSTANTIATE_TEST_SUITE_P(Windows, CensusCostTest,
                         testing::Values(Window{CensusWindow::k5x5, 2, 2, 10, 120},
                                         Window{CensusWindow::k9x7, 4, 3, 4, 124}));

TEST(CensusCostTest, BearsAnyRisingMapOfTheGrayLevels) {
  const VolumeShape shape{50, 20, 16, 0};
  cv::Mat left = RandomGray(shape.width, shape.height, 3) / 2;
  const cv::Mat brighter = left * 2 + 1;
  CensusCost cost;
  Prepare(left, brighter, shape, CensusWindow::k9x7, 1, &cost);
  AlignedBuffer<std::uint8_t> scratch;
  scratch.Resize(static_cast<std::size_t>(shape.width * shape.Stride()));
  const std::uint8_t* row = cost.Row(9, 0, shape.width, scratch.data());
  for (int x = 0; x < shape.width; ++x) EXPECT_EQ(row[x * shape.Stride()], 0);
}

}  // namespace
}  // namespace stereo_sgmp
