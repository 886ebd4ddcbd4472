#include "matcher/scaled_matcher.h"

#include <cmath>
#include <cstddef>
#include <numeric>

#include <gtest/gtest.h>

#include "scene/generated_scene.h"
#include "stereo_sgmp/presets.h"

namespace stereo_sgmp {
namespace {

// An odd size, which no level divides; one of the rooms whose largest plane is found whole in
// images as small as this at half their size.
const GeneratedScene& Scene() {
  static const GeneratedScene scene = MakeScene(SceneKind::kRoom, {321, 243}, 48, {}, 5);
  return scene;
}

MatchResult MatchAt(std::size_t level) {
  Options options = PresetOptions("quality");
  options.num_disparities = Scene().num_disparities;
  MatchInputs inputs;
  inputs.camera = Scene().camera;
  MatchResult result;
  ScaledMatcher(options).Match(Scene().left, Scene().right, inputs, options, LoadLevels()[level],
                               &result);
  return result;
}

// Shares of the pixels that both cameras see: within two pixels of the truth, and valid.
struct Score {
  double right = 0.0;
  double valid = 0.0;
};

Score ScoreOf(const MatchResult& result) {
  Score score;
  int seen = 0;
  for (int y = 0; y < result.dense.rows; ++y) {
    for (int x = 0; x < result.dense.cols; ++x) {
      if (Scene().mask.at<std::uint8_t>(y, x) != 255) continue;
      ++seen;
      if (result.reason.at<std::uint8_t>(y, x) != 0) continue;
      score.valid += 1.0;
      const float error = result.dense.at<float>(y, x) - Scene().disparity.at<float>(y, x);
      if (std::abs(error) <= 2.0f) score.right += 1.0;
    }
  }
  return {score.right / seen, score.valid / seen};
}

TEST(ScaledMatcherTest, EachLevelGivesMapsOfTheWholeImageThatAreRight) {
  for (std::size_t level = 0; level < LoadLevels().size(); ++level) {
    SCOPED_TRACE(LoadLevels()[level].name);
    const MatchResult result = MatchAt(level);
    for (const cv::Mat& map :
         {result.raw, result.dense, result.reason, result.confidence, result.uncertainty}) {
      EXPECT_EQ(map.size(), Scene().left.size());
    }
    const Score score = ScoreOf(result);
    EXPECT_GT(score.valid, 0.8);
    EXPECT_GT(score.right / score.valid, level < 4 ? 0.9 : 0.8);
    const MatchStatistics& statistics = result.statistics;
    EXPECT_EQ(std::accumulate(std::begin(statistics.reasons), std::end(statistics.reasons), 0),
              321 * 243);
    EXPECT_NEAR(statistics.density, statistics.reasons[0] / (321.0 * 243.0), 1e-9);
  }
}

TEST(ScaledMatcherTest, PlanesAreThoseOfTheWholeImage) {
  const MatchResult full = MatchAt(0);
  const MatchResult half = MatchAt(3);
  ASSERT_FALSE(full.priors.planes.empty());
  ASSERT_FALSE(half.priors.planes.empty());
  // The largest plane lies on the surface that its labels show.
  const PlaneHypothesis& plane = half.priors.planes[0];
  const cv::Mat on_plane = half.priors.labels == 0;
  const double to_x = 321.0 / on_plane.cols;
  const double to_y = 243.0 / on_plane.rows;
  int near_truth = 0;
  int all = 0;
  for (int y = 0; y < on_plane.rows; ++y) {
    for (int x = 0; x < on_plane.cols; ++x) {
      if (on_plane.at<std::uint8_t>(y, x) == 0) continue;
      const double u = (x + 0.5) * to_x - 0.5;
      const double v = (y + 0.5) * to_y - 0.5;
      const float truth = Scene().disparity.at<float>(static_cast<int>(v), static_cast<int>(u));
      ++all;
      if (std::abs(plane.plane.At(u, v) - truth) < 2.0) ++near_truth;
    }
  }
  EXPECT_GT(near_truth, 0.8 * all);
}

TEST(LoadLevelsTest, SearchTheSameDepthsWithLessWork) {
  const cv::Size size(640, 480);
  Options options;
  options.min_disparity = -7;
  options.num_disparities = 90;
  StereoCamera camera;
  camera.focal_length = 500.0;
  camera.baseline = 0.1;
  camera.doffs = 12.0;
  double work = 1e18;
  for (const LoadLevel& level : LoadLevels()) {
    SCOPED_TRACE(level.name);
    const Options lowered = OptionsAtLevel(options, size, level);
    const StereoCamera small = CameraAtLevel(camera, size, level);
    const int last = lowered.min_disparity + lowered.num_disparities - 1;
    EXPECT_GE(small.DepthOf(lowered.min_disparity), camera.DepthOf(-7) * (1.0 - 1e-9));
    EXPECT_LE(small.DepthOf(last), camera.DepthOf(82) * (1.0 + 1e-9));
    const double level_work = 1.0 * SizeAtLevel(size, level).area() * lowered.num_disparities -
                              (level.thorough ? 0.0 : 1.0);
    EXPECT_LT(level_work, work);
    work = level_work;
  }
}

}  // namespace
}  // namespace stereo_sgmp
