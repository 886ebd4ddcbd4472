#include "prior/estimated_prior.h"

#include <array>
#include <atomic>
#include <chrono>
#include <cstddef>
#include <cstdint>
#include <functional>
#include <memory>
#include <thread>

#include <gtest/gtest.h>

#include "prior/unpack_jumps.h"

namespace stereo_sgmp {
namespace {

constexpr int kCoarseWidth = 90;
constexpr int kCoarseHeight = 60;

VolumeShape FullShape() {
  VolumeShape shape;
  shape.width = 361;
  shape.height = 239;
  shape.disparities = 128;
  return shape;
}

PriorOptions OptionsOf(Variant variant) {
  PriorOptions options;
  options.variant = variant;
  return options;
}

// A slanted wall above, a floor in front of it below, in full-resolution pixels.
double SceneAt(double u, double v) { return v < 120 ? 20.0 + 0.1 * u : 64.0 + 0.3 * (v - 120); }

struct Inputs {
  cv::Mat disparity = cv::Mat(kCoarseHeight, kCoarseWidth, CV_32FC1);
  cv::Mat confident = cv::Mat(kCoarseHeight, kCoarseWidth, CV_8UC1, cv::Scalar(255));
  cv::Mat image = cv::Mat(kCoarseHeight, kCoarseWidth, CV_8UC3, cv::Scalar(60, 60, 60));

  Inputs() {
    const double sx = 361.0 / kCoarseWidth;
    const double sy = 239.0 / kCoarseHeight;
    for (int y = 0; y < kCoarseHeight; ++y) {
      const double v = (y + 0.5) * sy - 0.5;
      if (v >= 120) image.row(y).setTo(cv::Scalar(90, 160, 200));
      for (int x = 0; x < kCoarseWidth; ++x) {
        disparity.at<float>(y, x) = static_cast<float>(SceneAt((x + 0.5) * sx - 0.5, v) / sx);
      }
    }
  }
  CoarseDisparity Coarse() const { return {disparity, confident}; }
};

class EstimatedPriorOf : public testing::TestWithParam<Variant> {};

TEST_P(EstimatedPriorOf, FollowsThePlanesOfTheScene) {
  const Inputs inputs;
  EstimatedPrior estimated;
  ASSERT_NE(estimated.Estimate(OptionsOf(GetParam()), inputs.Coarse(), inputs.image, FullShape(),
                               nullptr),
            nullptr);
  const OrientationPrior* prior = estimated.parallel();
  ASSERT_NE(prior, nullptr);
  JumpRow row;
  prior->Jumps(30, 0, 361, {1, 0}, &row);
  int climbed = 0;
  for (std::size_t x = 61; x <= 260; ++x) climbed += row.jump[x];
  EXPECT_NEAR(climbed, 20, 1);
  climbed = 0;
  for (int v = 161; v <= 220; ++v) {
    prior->Jumps(v, 100, 101, {0, 1}, &row);
    climbed += row.jump[0];
  }
  EXPECT_NEAR(climbed, 18, 1);
}

TEST_P(EstimatedPriorOf, ReportsPlanesInFullResolution) {
  const Inputs inputs;
  EstimatedPrior estimated;
  estimated.Estimate(OptionsOf(GetParam()), inputs.Coarse(), inputs.image, FullShape(), nullptr);
  const PlanePriors& report = estimated.report();
  ASSERT_EQ(report.planes.size(), 2U);
  ASSERT_EQ(report.labels.size(), inputs.disparity.size());
  for (const cv::Point coarse : {cv::Point(40, 10), cv::Point(40, 50)}) {
    const std::int16_t label = report.labels.at<std::int16_t>(coarse);
    ASSERT_GE(label, 0);
    const double u = (coarse.x + 0.5) * 361 / kCoarseWidth - 0.5;
    const double v = (coarse.y + 0.5) * 239 / kCoarseHeight - 0.5;
    const PlaneHypothesis& found = report.planes[static_cast<std::size_t>(label)];
    EXPECT_NEAR(found.plane.At(u, v), SceneAt(u, v), 0.2);
    EXPECT_GT(found.support, 2000);
    EXPECT_LT(found.residual, 0.3);
  }
}

TEST_P(EstimatedPriorOf, SameForAnyThreads) {
  const Inputs inputs;
  ThreadPool threads(2);
  EstimatedPrior one;
  EstimatedPrior two;
  const PriorOptions options = OptionsOf(GetParam());
  const auto* a = one.Estimate(options, inputs.Coarse(), inputs.image, FullShape(), nullptr);
  const auto* b = two.Estimate(options, inputs.Coarse(), inputs.image, FullShape(), &threads);
  JumpRow row_a;
  JumpRow row_b;
  for (int y = 0; y < FullShape().height; y += 7) {
    a->Jumps(y, 0, 361, {1, 1}, &row_a);
    b->Jumps(y, 0, 361, {1, 1}, &row_b);
    EXPECT_EQ(Values(row_a.jump), Values(row_b.jump));
    ASSERT_EQ(row_a.segments.size(), row_b.segments.size());
    for (std::size_t i = 0; i < row_a.segments.size(); ++i) {
      EXPECT_EQ(row_a.segments[i].end, row_b.segments[i].end);
      EXPECT_EQ(row_a.segments[i].jump, row_b.segments[i].jump);
    }
  }
}

// Waits to be told, at most a minute; returns whether it was.
bool WaitForPlanes(const std::function<bool()>& have_planes) {
  const auto end = std::chrono::steady_clock::now() + std::chrono::minutes(1);
  while (!have_planes() && std::chrono::steady_clock::now() < end) std::this_thread::yield();
  return have_planes();
}

TEST_P(EstimatedPriorOf, WhatGoesOnBesideIsToldWhenThePlanesAreFound) {
  const Inputs inputs;
  for (const int threads : {0, 1, 2, 3}) {
    SCOPED_TRACE(threads);
    std::unique_ptr<ThreadPool> pool;
    if (threads > 0) pool = std::make_unique<ThreadPool>(threads);
    EstimatedPrior estimated;
    std::atomic<int> first{0};
    std::array<std::atomic<int>, 2> parts{};
    std::atomic<int> last{0};
    bool was_told = false;
    const SideWork beside{[&] { ++first; },
                          {[&] { parts[0] += first; }, [&] { parts[1] += first; }},
                          [&](const std::function<bool()>& have_planes) {
                            last += parts[0] * parts[1];
                            was_told = WaitForPlanes(have_planes);
                          }};
    estimated.Estimate(OptionsOf(GetParam()), inputs.Coarse(), inputs.image, FullShape(),
                       pool.get(), &beside);
    EXPECT_EQ(last, 1) << "each once, in their order";
    EXPECT_TRUE(was_told);
    EXPECT_EQ(estimated.report().planes.size(), 2U);
  }
}

TEST_P(EstimatedPriorOf, NothingConfidentGivesNoPrior) {
  Inputs inputs;
  inputs.confident.setTo(0);
  EstimatedPrior estimated;
  EXPECT_EQ(estimated.Estimate(OptionsOf(GetParam()), inputs.Coarse(), inputs.image, FullShape(),
                               nullptr),
            nullptr);
  EXPECT_TRUE(estimated.report().planes.empty());
  EXPECT_EQ(cv::countNonZero(estimated.report().labels != -1), 0);
}

TEST_P(EstimatedPriorOf, OnePixel) {
  VolumeShape shape;
  shape.width = 1;
  shape.height = 1;
  shape.disparities = 1;
  const cv::Mat disparity(1, 1, CV_32FC1, cv::Scalar(0));
  const cv::Mat confident(1, 1, CV_8UC1, cv::Scalar(255));
  const cv::Mat image(1, 1, CV_8UC1, cv::Scalar(0));
  EstimatedPrior estimated;
  EXPECT_EQ(
      estimated.Estimate(OptionsOf(GetParam()), {disparity, confident}, image, shape, nullptr),
      nullptr);
}

INSTANTIATE_TEST_SUITE_P(Variants, EstimatedPriorOf, testing::Values(Variant::kEpi, Variant::kEpv));

TEST(EstimatedPrior, BaselineHasNone) {
  const Inputs inputs;
  EstimatedPrior estimated;
  EXPECT_EQ(estimated.Estimate(OptionsOf(Variant::kSgm), inputs.Coarse(), inputs.image, FullShape(),
                               nullptr),
            nullptr);
}

}  // namespace
}  // namespace stereo_sgmp
