#include "evaluation/score.h"

#include <gtest/gtest.h>

namespace stereo_sgmp {
namespace {

// Four pixels: two good, one off by 1.5, one that no ground truth is known of.
StereoScene FourPixels() {
  StereoScene scene;
  scene.name = "four";
  scene.disparity = (cv::Mat_<float>(1, 4) << 10, 10, 10, 0);
  return scene;
}

MatchResult ResultFor() {
  MatchResult result;
  result.raw = (cv::Mat_<float>(1, 4) << 10, 11.5F, 10, 99);
  result.dense = (cv::Mat_<float>(1, 4) << 10, 10.75F, 10, 99);
  result.uncertainty = (cv::Mat_<float>(1, 4) << 1, 2, 3, 0);
  result.confidence = (cv::Mat_<float>(1, 4) << 0.9F, 0.1F, 0.5F, 1);
  result.statistics.frame_ms = 250;
  return result;
}

TEST(Score, MeasuresRawDenseAndCurves) {
  ScoreOptions options;
  options.curve_threshold = 1.0;
  const SceneScore score = ScoreResult(FourPixels(), ResultFor(), options);
  EXPECT_EQ(score.name, "four");
  EXPECT_DOUBLE_EQ(score.bad_raw[0], 100.0 / 3);
  EXPECT_DOUBLE_EQ(score.bad_raw[1], 100.0 / 3);
  EXPECT_DOUBLE_EQ(score.bad_raw[2], 0);
  EXPECT_DOUBLE_EQ(score.bad_dense[0], 100.0 / 3);
  EXPECT_DOUBLE_EQ(score.bad_dense[1], 0);
  EXPECT_DOUBLE_EQ(score.error_at[0], 50) << "two of three pixels, one of them bad";
  EXPECT_DOUBLE_EQ(score.area_uncertainty, 100 * (0 + 1.0 / 2 + 1.0 / 3) / 3);
  EXPECT_DOUBLE_EQ(score.area_confidence, 100 * (0 + 0 + 1.0 / 3) / 3);
  EXPECT_DOUBLE_EQ(score.seconds, 0.25);
}

TEST(Score, TableEndsWithTheMean) {
  SceneScore a;
  a.name = "a";
  a.bad_raw = {1};
  a.bad_dense = {3};
  a.seconds = 1;
  SceneScore b = a;
  b.name = "b";
  b.bad_raw = {2};
  ScoreOptions options;
  options.thresholds = {1.5};
  const std::string csv = ScoreTable({a, b}, options).ToCsv();
  EXPECT_EQ(csv,
            "scene,raw_bad_1.5,dense_bad_1.5,bad_2_at_60,bad_2_at_70,bad_2_at_80,bad_2_at_90,"
            "area_uncertainty,area_confidence,seconds\n"
            "a,1.000,3.000,0.000,0.000,0.000,0.000,0.000,0.000,1.000\n"
            "b,2.000,3.000,0.000,0.000,0.000,0.000,0.000,0.000,1.000\n"
            "mean,1.500,3.000,0.000,0.000,0.000,0.000,0.000,0.000,1.000\n");
}

}  // namespace
}  // namespace stereo_sgmp
