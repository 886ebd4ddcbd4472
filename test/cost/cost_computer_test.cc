#include "cost/cost_computer.h"

#include <cstring>
#include <stdexcept>
#include <string>

#include <gtest/gtest.h>

#include "cost_test_util.h"
#include "io/expect_message.h"

namespace stereo_sgmp {
namespace {

constexpr int kWidth = 70;
constexpr int kHeight = 9;
const VolumeShape kShape{kWidth, kHeight, 40, 0};

std::uint8_t CostAt(const CostRows& costs, int x, int y, int index) {
  AlignedBuffer<std::uint8_t> scratch;
  scratch.Resize(static_cast<std::size_t>(costs.shape().Stride()));
  return costs.Row(y, x, x + 1, scratch.data())[index];
}

TEST(CostComputerTest, PreparesTheCostOfTheOptions) {
  const cv::Mat left = RandomGray(kWidth, kHeight, 1);
  const cv::Mat right = RandomGray(kWidth, kHeight, 2);
  ThreadPool pool(2);
  CostComputer computer;
  CostOptions options;
  int unit = 1;
  const auto outside_cost = [&] {
    return CostAt(computer.Prepare(options, left, right, kShape, RadiometricFit(), unit, &pool), 0,
                  3, 1);
  };
  options.kind = CostKind::kMixed;
  EXPECT_EQ(outside_cost(), 188);
  options.kind = CostKind::kNcc;
  EXPECT_EQ(outside_cost(), 255);
  options.kind = CostKind::kCensus;
  EXPECT_EQ(outside_cost(), 124);
  options.census_window = CensusWindow::k5x5;
  EXPECT_EQ(outside_cost(), 120);
  unit = 7;
  EXPECT_EQ(outside_cost(), 17);
  options.kind = CostKind::kNcc;
  EXPECT_EQ(outside_cost(), 36);
  options.kind = CostKind::kMixed;
  EXPECT_EQ(outside_cost(), 26);
}

TEST(CostComputerTest, SaysWhichUnitsThereAre) {
  const cv::Mat image = RandomGray(kWidth, kHeight, 1);
  ThreadPool pool(1);
  CostComputer computer;
  const auto expect = [&](CostKind kind, int unit, const std::string& message) {
    CostOptions options;
    options.kind = kind;
    ExpectInvalid(
        [&] { computer.Prepare(options, image, image, kShape, RadiometricFit(), unit, &pool); },
        message);
  };
  expect(CostKind::kMixed, 5, "unit of the mixed cost is 5, expected 1 (full costs) or 7");
  expect(CostKind::kNcc, 17, "unit of the matching cost is 17, expected 1 (full costs) to 16");
  expect(CostKind::kCensus, 0, "unit of the matching cost is 0");
}

TEST(CostComputerTest, ForgetsTheLastPair) {
  ThreadPool pool(2);
  CostComputer used;
  CostComputer fresh;
  const VolumeShape small{31, 5, 12, -2};
  const cv::Mat left = RandomGray(small.width, small.height, 3);
  const cv::Mat right = RandomGray(small.width, small.height, 4);
  for (const CostKind kind : {CostKind::kMixed, CostKind::kNcc, CostKind::kCensus}) {
    CostOptions options;
    options.kind = kind;
    used.Prepare(options, RandomGray(kWidth, kHeight, 1), RandomGray(kWidth, kHeight, 2), kShape,
                 RadiometricFit(), 1, &pool);
    const CostRows& again = used.Prepare(options, left, right, small, RadiometricFit(), 1, &pool);
    const CostRows& once = fresh.Prepare(options, left, right, small, RadiometricFit(), 1, &pool);
    for (int x = 0; x < small.width; ++x) {
      for (int k = 0; k < small.disparities; ++k) {
        ASSERT_EQ(CostAt(again, x, 4, k), CostAt(once, x, 4, k));
      }
    }
  }
}

TEST(CostComputerTest, NamesTheImageThatDoesNotFit) {
  ThreadPool pool(1);
  CostComputer computer;
  const cv::Mat good = RandomGray(kWidth, kHeight, 1);
  const cv::Mat narrow = RandomGray(kWidth - 1, kHeight, 2);
  try {
    computer.Prepare(CostOptions(), good, narrow, kShape, RadiometricFit(), 1, &pool);
    FAIL() << "expected an exception";
  } catch (const std::invalid_argument& error) {
    EXPECT_NE(std::strstr(error.what(), "right image"), nullptr) << error.what();
    EXPECT_NE(std::strstr(error.what(), "69x9"), nullptr) << error.what();
  }
}

TEST(CostMemoryTest, OnlyNccHoldsAVolume) {
  const VolumeShape shape{640, 480, 128, 0};
  CostOptions options;
  options.kind = CostKind::kNcc;
  EXPECT_GT(CostMemory(options, shape), shape.PaddedSize());
  options.kind = CostKind::kMixed;
  EXPECT_LT(CostMemory(options, shape), shape.PaddedSize());
  options.kind = CostKind::kCensus;
  EXPECT_LT(CostMemory(options, shape), shape.PaddedSize());
}

}  // namespace
}  // namespace stereo_sgmp
