#include "prior/manhattan/manhattan_prior.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <map>
#include <stdexcept>
#include <vector>

#include <gtest/gtest.h>
#include <opencv2/imgproc.hpp>

#include "prior/manhattan/line_detector.h"
#include "prior/unpack_jumps.h"
#include "scene/generated_scene.h"

namespace stereo_sgmp {
namespace {

constexpr int kShrink = 4;
const cv::Size kSize(960, 640);
constexpr int kDisparities = 96;

// Rendered once for all tests.
const GeneratedScene& SceneOf(SceneKind kind) {
  static std::map<SceneKind, GeneratedScene> scenes;
  const auto [entry, is_new] = scenes.try_emplace(kind);
  if (is_new) entry->second = MakeScene(kind, kSize, kDisparities, {}, 3);
  return entry->second;
}

// A generated scene, with its exact disparities in place of those of a coarse pass.
struct Inputs {
  explicit Inputs(SceneKind kind) : scene(SceneOf(kind)) {
    shape.width = kSize.width;
    shape.height = kSize.height;
    shape.disparities = kDisparities;
    cv::resize(scene.disparity, disparity, kSize / kShrink, 0, 0, cv::INTER_AREA);
    disparity /= kShrink;
    cv::resize(scene.left, coarse_left, disparity.size(), 0, 0, cv::INTER_AREA);
    confident = cv::Mat(disparity.size(), CV_8UC1, cv::Scalar(255));
  }
  const OrientationPrior* Estimate(ManhattanPrior* prior, ThreadPool* threads = nullptr) const {
    return prior->Estimate(PriorOptions(), {disparity, confident}, scene.left, coarse_left,
                           scene.camera, shape, threads);
  }

  GeneratedScene scene;
  VolumeShape shape;
  cv::Mat coarse_left;
  cv::Mat disparity;
  cv::Mat confident;
};

// Angle between the surface at a pixel and the nearest direction of the frame; NaN where the
// disparities around it are no plane.
double DegreesOff(const GeneratedScene& scene, const ManhattanFrame& frame, int x, int y) {
  constexpr int kStep = 4;
  const auto d = [&scene](int u, int v) { return double{scene.disparity.at<float>(v, u)}; };
  const double middle = d(x, y);
  const double bend = std::abs(d(x - kStep, y) + d(x + kStep, y) - 2.0 * middle) +
                      std::abs(d(x, y - kStep) + d(x, y + kStep) - 2.0 * middle);
  if (!(bend < 1e-3)) return std::nan("");
  const double a = (d(x + kStep, y) - d(x - kStep, y)) / (2 * kStep);
  const double b = (d(x, y + kStep) - d(x, y - kStep)) / (2 * kStep);
  const Eigen::Vector3d normal = scene.camera.ToSpace({a, b, middle - a * x - b * y}).normal;
  const double cosine = (frame.directions.transpose() * normal).cwiseAbs().maxCoeff();
  return std::acos(std::min(cosine, 1.0)) * 57.29577951308232;
}

class ManhattanPriorOf : public testing::TestWithParam<SceneKind> {};

TEST_P(ManhattanPriorOf, FindsTheDirectionsOfTheScene) {
  if (!kHasLineDetector) GTEST_SKIP();
  const Inputs inputs(GetParam());
  ManhattanPrior prior;
  ASSERT_NE(inputs.Estimate(&prior), nullptr);
  ASSERT_TRUE(prior.frame().has_value());
  std::vector<double> off;
  for (int y = 10; y < kSize.height - 10; y += 20) {
    for (int x = 10; x < kSize.width - 10; x += 20) {
      const double degrees = DegreesOff(inputs.scene, *prior.frame(), x, y);
      if (!std::isnan(degrees)) off.push_back(degrees);
    }
  }
  ASSERT_GT(off.size(), 500U);
  std::sort(off.begin(), off.end());
  EXPECT_LT(off[off.size() * 95 / 100], 2.0);
}

TEST_P(ManhattanPriorOf, ReportsPlanesOnTheSurfaces) {
  if (!kHasLineDetector) GTEST_SKIP();
  const Inputs inputs(GetParam());
  ManhattanPrior prior;
  ASSERT_NE(inputs.Estimate(&prior), nullptr);
  const PlanePriors& report = prior.report();
  ASSERT_EQ(report.labels.size(), inputs.disparity.size());
  int right = 0;
  for (int y = 0; y < report.labels.rows; ++y) {
    for (int x = 0; x < report.labels.cols; ++x) {
      const int label = report.labels.at<std::int16_t>(y, x);
      if (label < 0) continue;
      ASSERT_LT(static_cast<std::size_t>(label), report.planes.size());
      const DisparityPlane& plane = report.planes[static_cast<std::size_t>(label)].plane;
      const double full = plane.At((x + 0.5) * kShrink - 0.5, (y + 0.5) * kShrink - 0.5);
      if (std::abs(full - inputs.disparity.at<float>(y, x) * kShrink) < 0.5) ++right;
    }
  }
  EXPECT_GT(right, 0.9 * static_cast<double>(report.labels.total()));
}

TEST_P(ManhattanPriorOf, SameForAnyThreads) {
  if (!kHasLineDetector) GTEST_SKIP();
  const Inputs inputs(GetParam());
  ThreadPool threads(3);
  ManhattanPrior one;
  ManhattanPrior two;
  const OrientationPrior* a = inputs.Estimate(&one);
  const OrientationPrior* b = inputs.Estimate(&two, &threads);
  ASSERT_TRUE(a != nullptr && b != nullptr);
  JumpRow row_a;
  JumpRow row_b;
  for (int y = 0; y < kSize.height; y += 50) {
    a->Jumps(y, 0, kSize.width, {1, 1}, &row_a);
    b->Jumps(y, 0, kSize.width, {1, 1}, &row_b);
    EXPECT_EQ(Values(row_a.jump), Values(row_b.jump));
  }
}

INSTANTIATE_TEST_SUITE_P(Scenes, ManhattanPriorOf,
                         testing::Values(SceneKind::kCorridor, SceneKind::kRoom));

TEST(ManhattanPrior, NoneForAPlainImage) {
  if (!kHasLineDetector) GTEST_SKIP();
  Inputs inputs(SceneKind::kRoom);
  ManhattanPrior prior;
  ASSERT_NE(inputs.Estimate(&prior), nullptr);
  inputs.scene.left = cv::Mat(kSize, CV_8UC3, cv::Scalar(90, 90, 90));
  EXPECT_EQ(inputs.Estimate(&prior), nullptr);
  EXPECT_FALSE(prior.frame().has_value());
  EXPECT_TRUE(prior.report().planes.empty());
  EXPECT_TRUE(prior.report().labels.empty());
}

TEST(ManhattanPrior, NoneWhereNoDisparityIsConfident) {
  if (!kHasLineDetector) GTEST_SKIP();
  Inputs inputs(SceneKind::kRoom);
  inputs.confident.setTo(0);
  ManhattanPrior prior;
  EXPECT_EQ(inputs.Estimate(&prior), nullptr);
  EXPECT_TRUE(prior.frame().has_value());
  EXPECT_TRUE(prior.report().planes.empty());
}

TEST(ManhattanPrior, InputsThatDoNotFitAreRejected) {
  Inputs inputs(SceneKind::kRoom);
  ManhattanPrior prior;
  inputs.shape.width -= 1;
  EXPECT_THROW(inputs.Estimate(&prior), std::invalid_argument);
  inputs.shape.width += 1;
  inputs.scene.camera.focal_length = 0.0;
  EXPECT_THROW(inputs.Estimate(&prior), std::invalid_argument);
}

}  // namespace
}  // namespace stereo_sgmp
