#include "matcher/load_governor.h"

#include <gtest/gtest.h>

#include "matcher/load_level.h"

namespace stereo_sgmp {
namespace {

constexpr double kBudget = 0.1;

void Repeat(int frames, double time, LoadGovernor* governor) {
  for (int i = 0; i < frames; ++i) governor->Update(time, kBudget);
}

TEST(LoadGovernorTest, StaysWhereThereIsTime) {
  LoadGovernor governor;
  Repeat(100, 0.09, &governor);
  EXPECT_EQ(governor.level(), 0);
}

TEST(LoadGovernorTest, ForgivesASingleLateFrame) {
  LoadGovernor governor;
  for (int i = 0; i < 20; ++i) {
    governor.Update(5.0, kBudget);
    Repeat(2, 0.05, &governor);
  }
  EXPECT_EQ(governor.level(), 0);
}

TEST(LoadGovernorTest, ForgivesLateFramesThatEarlyOnesMakeUpFor) {
  LoadGovernor governor;
  for (int i = 0; i < 100; ++i) {
    Repeat(2, 0.14, &governor);
    Repeat(4, 0.07, &governor);
  }
  EXPECT_EQ(governor.level(), 0);
}

TEST(LoadGovernorTest, LowersWhereFramesAreALittleLateForLong) {
  LoadGovernor governor;
  Repeat(9, 0.11, &governor);
  EXPECT_EQ(governor.level(), 0);
  Repeat(2, 0.11, &governor);
  EXPECT_EQ(governor.level(), 1);
}

TEST(LoadGovernorTest, GivesUpStepByStepDownToTheLast) {
  LoadGovernor governor;
  Repeat(2, 0.2, &governor);
  EXPECT_EQ(governor.level(), 1);
  Repeat(2, 0.2, &governor);
  EXPECT_EQ(governor.level(), 2);
  Repeat(100, 0.2, &governor);
  EXPECT_EQ(governor.level(), static_cast<int>(LoadLevels().size()) - 1);
}

TEST(LoadGovernorTest, ReturnsWhenThereIsTimeAgain) {
  LoadGovernor governor;
  Repeat(100, 0.2, &governor);
  Repeat(100, 0.01, &governor);
  EXPECT_EQ(governor.level(), 0);
}

TEST(LoadGovernorTest, StaysLowWhereTheLevelAboveWouldNotFit) {
  LoadGovernor governor;
  Repeat(4, 0.2, &governor);
  Repeat(500, 0.08, &governor);
  EXPECT_EQ(governor.level(), 2);
}

// Frames at level 0 never fit, those at level 1 look as if they would leave time for it.
TEST(LoadGovernorTest, TriesLessAndLessOften) {
  LoadGovernor governor;
  int raises = 0;
  for (int i = 0; i < 1000; ++i) {
    const int before = governor.level();
    governor.Update(before == 0 ? 0.2 : 0.05, kBudget);
    if (governor.level() < before) ++raises;
  }
  EXPECT_GE(raises, 2);
  EXPECT_LE(raises, 4);
}

// Level 0 never fits, so that it is tried seldom at last; that holds nothing else up.
TEST(LoadGovernorTest, ReturnsAtOnceToALevelThatHasFitted) {
  LoadGovernor governor;
  for (int i = 0; i < 2000; ++i) governor.Update(governor.level() == 0 ? 0.2 : 0.05, kBudget);
  ASSERT_LE(governor.level(), 1);
  Repeat(100, 0.2, &governor);
  EXPECT_EQ(governor.level(), static_cast<int>(LoadLevels().size()) - 1);
  Repeat(8 * static_cast<int>(LoadLevels().size()), 0.01, &governor);
  EXPECT_EQ(governor.level(), 1);
}

TEST(LoadGovernorTest, NoBudgetNoLimit) {
  LoadGovernor governor;
  Repeat(100, 0.2, &governor);
  governor.Update(10.0, 0.0);
  EXPECT_EQ(governor.level(), 0);
}

}  // namespace
}  // namespace stereo_sgmp
