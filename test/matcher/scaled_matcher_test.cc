#include "matcher/scaled_matcher.h"

#include <cmath>
#include <cstddef>
#include <numeric>

#include <gtest/gtest.h>

#include "scene/generated_scene.h"
#include "stereo_sgmp/presets.h"

namespace stereo_sgmp {
namespace {

// An odd size, which no level divides.
const GeneratedScene& Scene() {
  static const GeneratedScene kScene = MakeScene(SceneKind::kRoom, {321, 243}, 48, {}, 4);
  return kScene;
}

MatchResult MatchAt(std::size_t level, const GeneratedScene& scene = Scene()) {
  Options options = PresetOptions("quality");
  options.num_disparities = scene.num_disparities;
  MatchInputs inputs;
  inputs.camera = scene.camera;
  MatchResult result;
  ScaledMatcher(options).Match(scene.left, scene.right, inputs, options, LoadLevels()[level],
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
    EXPECT_GT(score.right / score.valid, level < 5 ? 0.9 : 0.8);
    const MatchStatistics& statistics = result.statistics;
    EXPECT_EQ(std::accumulate(std::begin(statistics.reasons), std::end(statistics.reasons), 0),
              321 * 243);
    EXPECT_NEAR(statistics.density, statistics.reasons[0] / (321.0 * 243.0), 1e-9);
  }
}

// A single plane, so that whatever is found at any level has to lie on it in the whole image.
TEST(ScaledMatcherTest, PlanesAreThoseOfTheWholeImage) {
  for (const unsigned seed : {1U, 2U, 3U}) {
    const GeneratedScene scene = MakeScene(SceneKind::kSlantedPlane, {321, 243}, 48, {}, seed);
    for (const std::size_t level : {std::size_t{0}, std::size_t{4}}) {
      SCOPED_TRACE(testing::Message() << "seed " << seed << ", " << LoadLevels()[level].name);
      const MatchResult result = MatchAt(level, scene);
      ASSERT_FALSE(result.priors.planes.empty());
      const DisparityPlane& plane = result.priors.planes[0].plane;
      for (const cv::Point p : {cv::Point(80, 60), cv::Point(240, 60), cv::Point(160, 121),
                                cv::Point(80, 180), cv::Point(240, 180)}) {
        EXPECT_NEAR(plane.At(p.x, p.y), scene.disparity.at<float>(p), 0.5) << p;
      }
    }
  }
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
                              (level.thorough ? 0.0 : 1.0) - (level.all_paths ? 0.0 : 1.0);
    EXPECT_EQ(lowered.aggregation.scheme,
              level.all_paths ? options.aggregation.scheme : PathScheme::kFour);
    EXPECT_LT(level_work, work);
    work = level_work;
  }
}

}  // namespace
}  // namespace stereo_sgmp
