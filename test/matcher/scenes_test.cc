// What a user sees: accuracy of the whole matcher on scenes with exact ground truth.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <vector>

#include "scene/generated_scene.h"
#include "stereo_sgmp/matcher.h"
#include "stereo_sgmp/presets.h"

namespace stereo_sgmp {
namespace {

// Share of the pixels that both cameras see whose error is more than `threshold`.
double BadShare(const GeneratedScene& scene, const cv::Mat& disparity, double threshold) {
  int seen = 0;
  int bad = 0;
  for (int y = 0; y < disparity.rows; ++y) {
    for (int x = 0; x < disparity.cols; ++x) {
      if (scene.mask.at<std::uint8_t>(y, x) != 255) continue;
      ++seen;
      const float error = disparity.at<float>(y, x) - scene.disparity.at<float>(y, x);
      if (!(std::abs(error) <= threshold)) ++bad;
    }
  }
  return static_cast<double>(bad) / seen;
}

MatchResult MatchScene(const GeneratedScene& scene, Options options,
                       const MatchInputs& inputs = {}) {
  options.num_disparities = scene.num_disparities;
  Matcher matcher(options);
  MatchResult result;
  matcher.Match(scene.left, scene.right, inputs, &result);
  return result;
}

double RawBad(const GeneratedScene& scene, Variant variant, double threshold,
              const MatchInputs& inputs = {}) {
  Options options;
  options.prior.variant = variant;
  return BadShare(scene, MatchScene(scene, options, inputs).raw, threshold);
}

// Both pixels beside steps of more than a disparity.
cv::Mat Discontinuities(const cv::Mat& disparity) {
  cv::Mat marked(disparity.size(), CV_8U, cv::Scalar(0));
  const auto mark = [&](cv::Point p, cv::Point q) {
    if (std::abs(disparity.at<float>(p) - disparity.at<float>(q)) <= 1.0F) return;
    marked.at<std::uint8_t>(p) = 255;
    marked.at<std::uint8_t>(q) = 255;
  };
  for (int y = 1; y < disparity.rows; ++y) {
    for (int x = 1; x < disparity.cols; ++x) {
      mark({x - 1, y}, {x, y});
      mark({x, y - 1}, {x, y});
    }
  }
  return marked;
}

TEST(ScenesTest, PriorsHalveTheErrorsOnWeaklyTexturedSlants) {
  const GeneratedScene scene = MakeScene(SceneKind::kCorridor, {960, 600}, 128, {}, 1);
  const double sgm = RawBad(scene, Variant::kSgm, 2.0);
  EXPECT_GT(sgm, 0.05);
  EXPECT_LT(RawBad(scene, Variant::kEpi, 2.0), sgm / 2.0);
  EXPECT_LT(RawBad(scene, Variant::kEpv, 2.0), sgm / 2.0);
}

TEST(ScenesTest, PriorsDoNoHarmOnFrontoParallelSurfaces) {
  const GeneratedScene scene = MakeScene(SceneKind::kFrontoParallel, {480, 320}, 64, {}, 2);
  const double sgm = RawBad(scene, Variant::kSgm, 1.0);
  EXPECT_LT(RawBad(scene, Variant::kEpi, 1.0), sgm * 1.03 + 1e-3);
  EXPECT_LT(RawBad(scene, Variant::kEpv, 1.0), sgm * 1.03 + 1e-3);
}

// Its bars cut the walls behind into strips. How far they stand before the walls is not in the
// normals: following these alone removes a seventh of the errors in place of a third.
TEST(ScenesTest, NormalsLeadAcrossTheBarsOfAFence) {
  const GeneratedScene scene = MakeScene(SceneKind::kFence, {640, 440}, 64, {}, 4);
  MatchInputs inputs;
  inputs.normals = scene.normals;
  inputs.camera = scene.camera;
  const double sgm = RawBad(scene, Variant::kSgm, 2.0);
  EXPECT_LT(RawBad(scene, Variant::kGnv, 2.0, inputs), 0.8 * sgm);
}

// All surfaces have one normal, which does not show where one ends.
TEST(ScenesTest, KnownDiscontinuitiesHelpNormals) {
  const GeneratedScene scene = MakeScene(SceneKind::kFrontoParallel, {480, 320}, 64, {}, 2);
  MatchInputs inputs;
  inputs.normals = scene.normals;
  inputs.camera = scene.camera;
  const double unknown = RawBad(scene, Variant::kGnv, 1.0, inputs);
  inputs.discontinuities = Discontinuities(scene.disparity);
  EXPECT_LT(RawBad(scene, Variant::kGnv, 1.0, inputs), 0.85 * unknown);
}

TEST(ScenesTest, TexturedSlantsAreMatchedToAFractionOfAPixel) {
  const double slants[][2] = {{0.0, 0.0}, {0.12, 0.0}, {-0.1, 0.05}, {0.0, 0.15}};
  for (const auto& slant : slants) {
    SCOPED_TRACE(::testing::Message() << slant[0] << ", " << slant[1]);
    const GeneratedScene scene = MakeSlantedPlane({320, 240}, 64, slant[0], slant[1], {}, 5);
    const MatchResult result = MatchScene(scene, Options());
    EXPECT_LT(BadShare(scene, result.dense, 1.0), 0.02);
    EXPECT_LT(BadShare(scene, result.dense, 0.5), 0.06);
  }
}

TEST(ScenesTest, ExposureAndMisalignmentAreCompensated) {
  SceneQuality ideal;
  SceneQuality real;
  real.gain = 0.8;
  real.offset = 12.0;
  real.vertical_offset = 0.7;
  real.vertical_scale = 1.001;
  const GeneratedScene easy = MakeScene(SceneKind::kRoom, {640, 400}, 96, ideal, 6);
  const GeneratedScene hard = MakeScene(SceneKind::kRoom, {640, 400}, 96, real, 6);
  const MatchResult result = MatchScene(hard, Options());
  EXPECT_TRUE(result.statistics.alignment.applied);
  EXPECT_NEAR(result.statistics.alignment.offset, 0.7, 0.25);
  EXPECT_LT(BadShare(hard, result.dense, 1.0),
            BadShare(easy, MatchScene(easy, Options()).dense, 1.0) * 1.3 + 0.01);
}

TEST(ScenesTest, ConfidenceSortsErrors) {
  SceneQuality quality;
  quality.contrast = 1.4;  // with less, hardly a pixel of some surfaces is certain
  const GeneratedScene scene = MakeScene(SceneKind::kCorridor, {640, 400}, 96, quality, 7);
  const MatchResult result = MatchScene(scene, Options());
  std::vector<float> sorted(result.confidence.begin<float>(), result.confidence.end<float>());
  std::nth_element(sorted.begin(), sorted.begin() + static_cast<std::ptrdiff_t>(sorted.size() / 2),
                   sorted.end());
  GeneratedScene confident = scene;
  confident.mask = scene.mask.clone();
  confident.mask.setTo(0, result.confidence < sorted[sorted.size() / 2]);
  EXPECT_LT(BadShare(confident, result.raw, 1.0), BadShare(scene, result.raw, 1.0) / 4.0);
}

TEST(ScenesTest, FilteredPixelsAreMostlyRight) {
  const GeneratedScene scene = MakeScene(SceneKind::kRoom, {640, 400}, 96, {}, 8);
  const MatchResult result = MatchScene(scene, Options());
  GeneratedScene valid = scene;
  valid.mask = scene.mask.clone();
  valid.mask.setTo(0, result.reason);
  EXPECT_GT(result.statistics.density, 0.6);
  EXPECT_LT(BadShare(valid, result.dense, 1.0), 0.05);
}

}  // namespace
}  // namespace stereo_sgmp
