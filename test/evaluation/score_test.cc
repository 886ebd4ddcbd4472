#include "evaluation/score.h"

#include <cmath>
#include <cstdint>

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

MethodResult ResultFor() {
  MethodResult result;
  result.raw = (cv::Mat_<float>(1, 4) << 10, 11.5F, 10, 99);
  result.dense = (cv::Mat_<float>(1, 4) << 10, 10.75F, 10, 99);
  result.uncertainty = (cv::Mat_<float>(1, 4) << 1, 2, 3, 0);
  result.confidence = (cv::Mat_<float>(1, 4) << 0.9F, 0.1F, 0.5F, 1);
  result.valid = (cv::Mat_<std::uint8_t>(1, 4) << 255, 255, 0, 255);
  result.seconds = 0.25;
  return result;
}

TEST(Score, MeasuresRawDenseAndCurves) {
  ScoreOptions options;
  options.curve_threshold = 1.0;
  const SceneScore score = ScoreResult(FourPixels(), "epi", ResultFor(), options);
  EXPECT_EQ(score.scene, "four");
  EXPECT_EQ(score.method, "epi");
  EXPECT_DOUBLE_EQ(score.bad_raw[0], 100.0 / 3);
  EXPECT_DOUBLE_EQ(score.bad_raw[1], 100.0 / 3);
  EXPECT_DOUBLE_EQ(score.bad_raw[2], 0);
  EXPECT_DOUBLE_EQ(score.bad_dense[0], 100.0 / 3);
  EXPECT_DOUBLE_EQ(score.bad_dense[1], 0);
  EXPECT_DOUBLE_EQ(score.error_at[0], 50) << "two of three pixels, one of them bad";
  EXPECT_DOUBLE_EQ(score.area_uncertainty, 100 * (0 + 1.0 / 2 + 1.0 / 3) / 3);
  EXPECT_DOUBLE_EQ(score.area_confidence, 100 * (0 + 0 + 1.0 / 3) / 3);
  EXPECT_DOUBLE_EQ(score.area_oracle, 100 * (0 + 0 + 1.0 / 3) / 3);
  EXPECT_DOUBLE_EQ(score.bad_at_curve_threshold, 100.0 / 3);
  EXPECT_DOUBLE_EQ(score.average_error, 0.5);
  EXPECT_DOUBLE_EQ(score.seconds, 0.25);
}

TEST(Score, CountsInvalidPixelsApart) {
  MethodResult result = ResultFor();
  const SceneScore score = ScoreResult(FourPixels(), "epi", result, {});
  EXPECT_DOUBLE_EQ(score.invalid, 100.0 / 3);
  EXPECT_DOUBLE_EQ(score.bad_published[0], 100.0 / 3) << "the second pixel is off by 0.75";
  EXPECT_DOUBLE_EQ(score.bad_published[1], 0);
  result.valid.at<std::uint8_t>(0, 1) = 0;
  EXPECT_DOUBLE_EQ(ScoreResult(FourPixels(), "epi", result, {}).bad_published[0], 0);
}

TEST(Score, SamplesTheCurves) {
  ScoreOptions options;
  options.curve_threshold = 1.0;
  const SampledCurve curve = ScoreResult(FourPixels(), "epi", ResultFor(), options).curve;
  ASSERT_EQ(curve.completeness.size(), 100U);
  EXPECT_DOUBLE_EQ(curve.completeness.front(), 0.01);
  EXPECT_DOUBLE_EQ(curve.completeness.back(), 1.0);
  EXPECT_DOUBLE_EQ(curve.error_u[65], 50) << "two of three pixels, one of them bad";
  EXPECT_DOUBLE_EQ(curve.error_confidence[65], 0);
  EXPECT_DOUBLE_EQ(curve.error_confidence.back(), 100.0 / 3);
}

TEST(Score, HasNoCurveByUncertaintyWithoutOne) {
  MethodResult result = ResultFor();
  result.uncertainty.release();
  const SceneScore score = ScoreResult(FourPixels(), "other", result, {});
  EXPECT_TRUE(std::isnan(score.area_uncertainty));
  EXPECT_TRUE(std::isnan(score.error_at[0]));
  EXPECT_TRUE(std::isnan(score.curve.error_u[10]));
  EXPECT_FALSE(std::isnan(score.area_confidence));
}

TEST(Score, LeavesErrorsBelowTheShareAlone) {
  ScoreOptions options;
  options.min_error_share = 0.2;
  const SceneScore score = ScoreResult(FourPixels(), "epi", ResultFor(), options);
  EXPECT_DOUBLE_EQ(score.bad_raw[0], 0) << "off by 1.5 of 10";
}

}  // namespace
}  // namespace stereo_sgmp
