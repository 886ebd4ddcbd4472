#include "alignment/rig_alignment.h"

#include <vector>

#include <gtest/gtest.h>

#include "textured_pair.h"

namespace stereo_sgmp {
namespace {

const cv::Size kSize(320, 240);
constexpr int kDisparities = 32;

AlignmentOptions Options(AlignmentMode mode, int refresh_interval = 100) {
  AlignmentOptions options;
  options.mode = mode;
  options.refresh_interval = refresh_interval;
  return options;
}

AlignmentReport UpdateWith(RigAlignment* rig, const AlignmentOptions& options,
                           const TexturedPair& pair) {
  return rig->Update(options, pair.left, pair.right, 0, kDisparities);
}

TEST(RigAlignmentTest, OffLeavesTheImagesAlone) {
  RigAlignment rig;
  const TexturedPair pair = MakePair(kSize, 12.0, 1.0, 2.0);
  EXPECT_FALSE(UpdateWith(&rig, Options(AlignmentMode::kOff), pair).applied);
}

TEST(RigAlignmentTest, AutoAppliesWhatIsVisible) {
  RigAlignment rig;
  const TexturedPair shifted = MakePair(kSize, 12.0, 1.002, 0.5);
  const AlignmentReport report = UpdateWith(&rig, Options(AlignmentMode::kAuto), shifted);
  EXPECT_TRUE(report.applied);
  EXPECT_NEAR(report.scale, 1.002, 0.0004);
  EXPECT_NEAR(report.offset, 0.5, 0.05);
  EXPECT_NEAR(report.median_offset, 0.74, 0.1);
  EXPECT_GE(report.inliers, 30);
}

TEST(RigAlignmentTest, OnlyOnAppliesWhatIsInvisible) {
  const TexturedPair aligned = MakePair(kSize, 12.0, 1.0, 0.0);
  RigAlignment automatic;
  EXPECT_FALSE(UpdateWith(&automatic, Options(AlignmentMode::kAuto), aligned).applied);
  RigAlignment always;
  EXPECT_TRUE(UpdateWith(&always, Options(AlignmentMode::kOn), aligned).applied);
}

TEST(RigAlignmentTest, WithoutTextureNothingIsApplied) {
  const cv::Mat flat(kSize, CV_8UC1, cv::Scalar(90));
  for (const AlignmentMode mode : {AlignmentMode::kAuto, AlignmentMode::kOn}) {
    RigAlignment rig;
    const AlignmentReport report = rig.Update(Options(mode), flat, flat, 0, kDisparities);
    EXPECT_FALSE(report.applied);
    EXPECT_EQ(report.scale, 1.0);
    EXPECT_EQ(report.offset, 0.0);
  }
}

TEST(RigAlignmentTest, FramesWithoutTextureKeepWhatWasLearnt) {
  RigAlignment rig;
  const AlignmentOptions options = Options(AlignmentMode::kAuto, 2);
  const TexturedPair pair = MakePair(kSize, 12.0, 1.0, 0.8);
  for (int i = 0; i < 5; ++i) UpdateWith(&rig, options, pair);
  const cv::Mat flat(kSize, CV_8UC1, cv::Scalar(90));
  AlignmentReport report;
  for (int i = 0; i < 8; ++i) report = rig.Update(options, flat, flat, 0, kDisparities);
  EXPECT_TRUE(report.applied);
  EXPECT_NEAR(report.offset, 0.8, 0.05);
}

TEST(RigAlignmentTest, RefreshFollowsARigThatMoved) {
  RigAlignment rig;
  const AlignmentOptions options = Options(AlignmentMode::kAuto, 4);
  const TexturedPair before = MakePair(kSize, 12.0, 1.0, 0.8);
  const TexturedPair after = MakePair(kSize, 12.0, 1.0, -0.6);
  for (int i = 0; i < 5; ++i) UpdateWith(&rig, options, before);
  std::vector<double> offsets;
  for (int i = 0; i < 40; ++i) offsets.push_back(UpdateWith(&rig, options, after).offset);
  EXPECT_NEAR(offsets[4], 0.8, 0.05) << "one fit must not turn the rig round";
  EXPECT_NEAR(offsets.back(), -0.6, 0.05);
}

TEST(RigAlignmentTest, DependsOnTheSequenceOfFramesOnly) {
  const AlignmentOptions options = Options(AlignmentMode::kAuto, 3);
  const TexturedPair pairs[] = {MakePair(kSize, 12.0, 1.001, 0.3, 1.0, 1),
                                MakePair(kSize, 9.0, 1.001, 0.4, 1.0, 2)};
  RigAlignment rigs[2];
  for (int frame = 0; frame < 20; ++frame) {
    const TexturedPair& pair = pairs[frame % 2];
    const AlignmentReport first = UpdateWith(&rigs[0], options, pair);
    const AlignmentReport second = UpdateWith(&rigs[1], options, pair);
    ASSERT_EQ(first.offset, second.offset) << "frame " << frame;
    ASSERT_EQ(first.scale, second.scale) << "frame " << frame;
  }
}

TEST(RigAlignmentTest, ResetAndANewSizeForgetTheRig) {
  const cv::Mat flat(kSize, CV_8UC1, cv::Scalar(90));
  const AlignmentOptions options = Options(AlignmentMode::kAuto);
  RigAlignment rig;
  EXPECT_TRUE(UpdateWith(&rig, options, MakePair(kSize, 12.0, 1.0, 0.8)).applied);
  rig.Reset();
  EXPECT_FALSE(rig.Update(options, flat, flat, 0, kDisparities).applied);

  EXPECT_TRUE(UpdateWith(&rig, options, MakePair(cv::Size(300, 240), 12.0, 1.0, 0.8)).applied);
  EXPECT_FALSE(rig.Update(options, flat, flat, 0, kDisparities).applied);
}

}  // namespace
}  // namespace stereo_sgmp
