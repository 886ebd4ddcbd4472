// The matcher with what is known of a pair beyond its images.
#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <stdexcept>
#include <string>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "scene/generated_scene.h"
#include "stereo_sgmp/matcher.h"
#include "stereo_sgmp/presets.h"

namespace stereo_sgmp {
namespace {

using ::testing::AllOf;
using ::testing::HasSubstr;

// Weakly textured walls along the directions of a Manhattan world.
const GeneratedScene& Corridor() {
  static const GeneratedScene kScene = MakeScene(SceneKind::kCorridor, {320, 200}, 48, {}, 4);
  return kScene;
}

Options OptionsOf(Variant variant, const std::string& preset = "default") {
  Options options = PresetOptions(preset);
  options.prior.variant = variant;
  options.num_disparities = Corridor().num_disparities;
  return options;
}

// All that the scene knows.
MatchInputs TrueInputs(const GeneratedScene& scene) {
  MatchInputs inputs;
  inputs.surface = scene.disparity;
  inputs.normals = scene.normals;
  inputs.camera = scene.camera;
  return inputs;
}

MatchResult MatchOnce(const Options& options, const MatchInputs& inputs) {
  Matcher matcher(options);
  MatchResult result;
  matcher.Match(Corridor().left, Corridor().right, inputs, &result);
  return result;
}

std::string ErrorOf(const Options& options, const MatchInputs& inputs) {
  try {
    MatchOnce(options, inputs);
  } catch (const std::invalid_argument& error) {
    return error.what();
  }
  return "no error";
}

void ExpectSameDisparities(const MatchResult& a, const MatchResult& b) {
  EXPECT_EQ(cv::norm(a.raw, b.raw, cv::NORM_INF), 0.0);
  EXPECT_EQ(cv::norm(a.dense, b.dense, cv::NORM_INF), 0.0);
  EXPECT_EQ(cv::norm(a.uncertainty, b.uncertainty, cv::NORM_INF), 0.0);
  EXPECT_EQ(cv::norm(a.reason, b.reason, cv::NORM_INF), 0.0);
}

// Share of the pixels seen by both cameras whose winner is wrong by more than a disparity.
double BadShare(const MatchResult& result) {
  int seen = 0;
  int bad = 0;
  for (int y = 0; y < result.raw.rows; ++y) {
    for (int x = 0; x < result.raw.cols; ++x) {
      if (Corridor().mask.at<std::uint8_t>(y, x) != 255) continue;
      ++seen;
      const float error = result.raw.at<float>(y, x) - Corridor().disparity.at<float>(y, x);
      if (!(std::abs(error) <= 1.0F)) ++bad;
    }
  }
  return static_cast<double>(bad) / seen;
}

class VariantOf : public ::testing::TestWithParam<Variant> {};

TEST_P(VariantOf, KnowledgeOfTheSceneHelps) {
  const double sgm = BadShare(MatchOnce(OptionsOf(Variant::kSgm), {}));
  EXPECT_GT(sgm, 0.03);
  const MatchResult result = MatchOnce(OptionsOf(GetParam()), TrueInputs(Corridor()));
  EXPECT_LT(BadShare(result), 0.8 * sgm);
  EXPECT_EQ(result.priors.variant, GetParam());
  EXPECT_EQ(result.priors.note, "");
  const bool of_planes = GetParam() == Variant::kGp || GetParam() == Variant::kMw;
  EXPECT_EQ(result.priors.planes.empty(), !of_planes);
  EXPECT_EQ(result.priors.labels.empty(), !of_planes);
  EXPECT_EQ(result.statistics.planes, static_cast<int>(result.priors.planes.size()));
}

TEST_P(VariantOf, SameForAnyThreadsAndWhateverCameBefore) {
  Options options = OptionsOf(GetParam());
  options.threads = 1;
  const MatchInputs inputs = TrueInputs(Corridor());
  const MatchResult one = MatchOnce(options, inputs);
  Matcher matcher(OptionsOf(Variant::kEpv));
  MatchResult result;
  matcher.Match(Corridor().left, Corridor().right, &result);
  options.threads = 3;
  matcher.SetOptions(options);
  matcher.Match(Corridor().left, Corridor().right, inputs, &result);
  ExpectSameDisparities(result, one);
  EXPECT_EQ(result.priors.planes.size(), one.priors.planes.size());
}

INSTANTIATE_TEST_SUITE_P(All, VariantOf,
                         ::testing::Values(Variant::kGs, Variant::kGp, Variant::kGni, Variant::kGnv,
                                           Variant::kMw));

TEST(MatchInputsTest, WhatIsMissingIsNamedWithTheVariant) {
  MatchInputs camera_only;
  camera_only.camera = Corridor().camera;
  MatchInputs normals_only;
  normals_only.normals = Corridor().normals;
  EXPECT_THAT(ErrorOf(OptionsOf(Variant::kGs), {}),
              AllOf(HasSubstr("variant gs"), HasSubstr("surface"), HasSubstr("none was given")));
  EXPECT_THAT(ErrorOf(OptionsOf(Variant::kGp), {}),
              AllOf(HasSubstr("variant gp"), HasSubstr("surface"), HasSubstr("none was given")));
  EXPECT_THAT(ErrorOf(OptionsOf(Variant::kGni), camera_only),
              AllOf(HasSubstr("variant gni"), HasSubstr("normal map"), HasSubstr("none was")));
  EXPECT_THAT(ErrorOf(OptionsOf(Variant::kGnv), normals_only),
              AllOf(HasSubstr("variant gnv"), HasSubstr("camera"), HasSubstr("none was given")));
  EXPECT_THAT(ErrorOf(OptionsOf(Variant::kMw), {}),
              AllOf(HasSubstr("variant mw"), HasSubstr("camera"), HasSubstr("none was given")));
}

TEST(MatchInputsTest, WhatDoesNotFitIsNamedWithWhatIsExpected) {
  MatchInputs inputs = TrueInputs(Corridor());
  inputs.surface = Corridor().disparity.colRange(0, 310);
  EXPECT_THAT(ErrorOf(OptionsOf(Variant::kGs), inputs),
              AllOf(HasSubstr("variant gs"), HasSubstr("320x200"), HasSubstr("310x200")));
  inputs.surface = Corridor().left;
  EXPECT_THAT(ErrorOf(OptionsOf(Variant::kGp), inputs),
              AllOf(HasSubstr("variant gp"), HasSubstr("one float"), HasSubstr("type 16")));
  inputs.normals = Corridor().disparity;
  EXPECT_THAT(ErrorOf(OptionsOf(Variant::kGnv), inputs),
              AllOf(HasSubstr("variant gnv"), HasSubstr("three floats"), HasSubstr("type 5")));
  inputs = TrueInputs(Corridor());
  inputs.discontinuities = cv::Mat(10, 10, CV_8U);
  EXPECT_THAT(ErrorOf(OptionsOf(Variant::kGnv), inputs),
              AllOf(HasSubstr("discontinuities"), HasSubstr("one byte"), HasSubstr("10x10")));
  inputs = TrueInputs(Corridor());
  inputs.camera->baseline = 0.0;
  EXPECT_THAT(ErrorOf(OptionsOf(Variant::kMw), inputs), HasSubstr("baseline"));
}

TEST(MatchInputsTest, AMissingInputLeavesTheMatcherUsable) {
  Matcher matcher(OptionsOf(Variant::kGs));
  MatchResult result;
  EXPECT_THROW(matcher.Match(Corridor().left, Corridor().right, &result), std::invalid_argument);
  const MatchInputs inputs = TrueInputs(Corridor());
  matcher.Match(Corridor().left, Corridor().right, inputs, &result);
  ExpectSameDisparities(result, MatchOnce(OptionsOf(Variant::kGs), inputs));
}

TEST(MatchInputsTest, InputsThatTheVariantDoesNotNeedChangeNothing) {
  for (const Variant variant : {Variant::kSgm, Variant::kEpi, Variant::kEpv}) {
    ExpectSameDisparities(MatchOnce(OptionsOf(variant), TrueInputs(Corridor())),
                          MatchOnce(OptionsOf(variant), {}));
  }
}

class PresetOf : public ::testing::TestWithParam<std::string> {};

TEST_P(PresetOf, AConstantSurfaceIsPlainSgm) {
  const MatchResult sgm = MatchOnce(OptionsOf(Variant::kSgm, GetParam()), {});
  MatchInputs inputs;
  inputs.surface = cv::Mat(Corridor().left.size(), CV_32FC1, cv::Scalar(17.3));
  ExpectSameDisparities(MatchOnce(OptionsOf(Variant::kGs, GetParam()), inputs), sgm);
}

TEST_P(PresetOf, AWholeNumberAddedToTheSurfaceChangesNothing) {
  // Multiples of 2^-8: adding to them is exact.
  cv::Mat steps;
  Corridor().disparity.convertTo(steps, CV_32SC1, 256.0);
  MatchInputs inputs;
  steps.convertTo(inputs.surface, CV_32FC1, 1.0 / 256.0);
  const MatchResult expected = MatchOnce(OptionsOf(Variant::kGs, GetParam()), inputs);
  inputs.surface += 23.0;
  ExpectSameDisparities(MatchOnce(OptionsOf(Variant::kGs, GetParam()), inputs), expected);
}

INSTANTIATE_TEST_SUITE_P(All, PresetOf, ::testing::Values("default", "quality", "paper"));

TEST(MatchInputsTest, WithoutAnyKnownSurfaceThereIsNoPrior) {
  const MatchResult sgm = MatchOnce(OptionsOf(Variant::kSgm), {});
  MatchInputs inputs;
  const float unknown = std::numeric_limits<float>::quiet_NaN();
  inputs.surface = cv::Mat(Corridor().left.size(), CV_32FC1, cv::Scalar(unknown));
  for (const Variant variant : {Variant::kGs, Variant::kGp}) {
    ExpectSameDisparities(MatchOnce(OptionsOf(variant), inputs), sgm);
  }
}

TEST(MatchInputsTest, NormalsWithoutAnySurfaceAreRefused) {
  MatchInputs inputs = TrueInputs(Corridor());
  inputs.normals = cv::Mat(Corridor().left.size(), CV_32FC3, cv::Scalar());
  EXPECT_THAT(ErrorOf(OptionsOf(Variant::kGni), inputs), HasSubstr("shows no surface"));
  EXPECT_THAT(ErrorOf(OptionsOf(Variant::kGnv), inputs), HasSubstr("shows no surface"));
}

TEST(MatchInputsTest, AManhattanWorldThatIsNotThereFallsBackToEpv) {
  // Noise has no lines, and shifted by ten pixels one plane.
  cv::Mat wide(120, 170, CV_8UC1);
  cv::RNG random(8);
  random.fill(wide, cv::RNG::UNIFORM, 0, 256);
  const cv::Mat left = wide.colRange(0, 160).clone();
  const cv::Mat right = wide.colRange(10, 170).clone();
  MatchInputs inputs;
  inputs.camera = Corridor().camera;
  MatchResult mw;
  Matcher(OptionsOf(Variant::kMw)).Match(left, right, inputs, &mw);
  EXPECT_EQ(mw.priors.variant, Variant::kEpv);
  EXPECT_THAT(mw.priors.note, AllOf(HasSubstr("lines"), HasSubstr("epv")));
  MatchResult epv;
  Matcher(OptionsOf(Variant::kEpv)).Match(left, right, &epv);
  EXPECT_EQ(epv.priors.note, "");
  ASSERT_FALSE(epv.priors.planes.empty());
  EXPECT_EQ(mw.priors.planes.size(), epv.priors.planes.size());
  ExpectSameDisparities(mw, epv);
}

// Costs that are least at the true disparity.
CostVolume TrueCosts() {
  const cv::Mat& disparity = Corridor().disparity;
  CostVolume volume;
  volume.width = disparity.cols;
  volume.height = disparity.rows;
  volume.disparities = Corridor().num_disparities;
  for (int y = 0; y < disparity.rows; ++y) {
    for (int x = 0; x < disparity.cols; ++x) {
      for (int d = 0; d < volume.disparities; ++d) {
        const float distance = std::abs(disparity.at<float>(y, x) - static_cast<float>(d));
        volume.costs.push_back(static_cast<std::uint8_t>(std::min(40.0F * distance, 200.0F)));
      }
    }
  }
  return volume;
}

TEST(MatchInputsTest, GivenCostsTakeThePlaceOfTheMatchersOwn) {
  const CostVolume volume = TrueCosts();
  MatchInputs inputs;
  inputs.costs = &volume;
  for (const Variant variant : {Variant::kSgm, Variant::kEpv}) {
    EXPECT_LT(BadShare(MatchOnce(OptionsOf(variant), inputs)), 0.005);
  }
}

TEST(MatchInputsTest, CostsOfAnotherShapeAreRefused) {
  CostVolume volume = TrueCosts();
  MatchInputs inputs;
  inputs.costs = &volume;
  Options options = OptionsOf(Variant::kSgm);
  options.num_disparities = 32;
  EXPECT_THAT(ErrorOf(options, inputs), HasSubstr("set num_disparities to 48"));
  options.num_disparities = 48;
  options.min_disparity = 1;
  EXPECT_THAT(ErrorOf(options, inputs), HasSubstr("set min_disparity to 0"));
  options.min_disparity = 0;
  volume.width = 200;
  volume.height = 320;
  EXPECT_THAT(ErrorOf(options, inputs), AllOf(HasSubstr("200 x 320"), HasSubstr("320 x 200")));
}

}  // namespace
}  // namespace stereo_sgmp
