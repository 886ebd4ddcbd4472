#include "evaluation/methods/method_list.h"

#include <algorithm>
#include <cmath>

#include <gtest/gtest.h>
#include <opencv2/core/utility.hpp>
#include <opencv2/imgproc.hpp>

#include "evaluation/metrics.h"
#include "io/expect_message.h"
#include "scene/generated_scene.h"

namespace stereo_sgmp {
namespace {

constexpr int kDisparities = 24;

StereoScene SmallScene() {
  const GeneratedScene generated =
      MakeScene(SceneKind::kFrontoParallel, cv::Size(200, 120), kDisparities, {}, 1);
  StereoScene scene;
  scene.left = generated.left;
  scene.right = generated.right;
  scene.disparity = generated.disparity;
  scene.mask = generated.mask;
  scene.calibration = Calibration{generated.camera, generated.left.size(), kDisparities};
  return scene;
}

double BadDense(const StereoScene& scene, const MethodResult& result) {
  return BadPercent(result.dense, scene.disparity, EvaluatedPixels(scene.disparity, scene.mask),
                    {1.0});
}

TEST(MethodList, RunsEveryMethodThatItNames) {
  const StereoScene scene = SmallScene();
  for (const std::string& name : MethodNames()) {
    const auto method = MakeMethod(name, Options());
    EXPECT_EQ(method->name(), name);
    EXPECT_EQ(method->Missing(scene), "") << name;
    const MethodResult result = method->Run(scene, kDisparities);
    EXPECT_LT(BadDense(scene, result), 15) << name;
    EXPECT_EQ(cv::countNonZero(IsFinite(result.dense)), 200 * 120) << name;
    EXPECT_EQ(result.valid.type(), CV_8U) << name;
    EXPECT_EQ(result.confidence.size(), scene.left.size()) << name;
    EXPECT_GT(result.seconds, 0) << name;
  }
}

TEST(MethodList, RefusesOtherNames) {
  ExpectInvalid([] { MakeMethod("best", Options()); }, "best");
}

TEST(MatcherMethod, NeedsTheCameraForNormalsAndManhattanWorlds) {
  StereoScene scene = SmallScene();
  scene.calibration.reset();
  for (const char* name : {"gni", "gnv", "mw"}) {
    EXPECT_NE(MakeMethod(name, Options())->Missing(scene), "") << name;
  }
  for (const char* name : {"sgm", "epi", "epv", "gs", "gp"}) {
    EXPECT_EQ(MakeMethod(name, Options())->Missing(scene), "") << name;
  }
}

TEST(MatcherMethod, VouchesForThePixelsThatPassItsFilters) {
  Options strict;
  strict.filter.min_confidence = 1.0;
  const StereoScene scene = SmallScene();
  const MethodResult few = MakeMethod("sgm", strict)->Run(scene, kDisparities);
  const MethodResult many = MakeMethod("sgm", Options())->Run(scene, kDisparities);
  EXPECT_LT(cv::countNonZero(few.valid), cv::countNonZero(many.valid));
  EXPECT_FALSE(few.uncertainty.empty());
}

TEST(SgbmMethod, MatchesTheColumnsThatOpenCvLeavesOut) {
  const StereoScene scene = SmallScene();
  const MethodResult result = MakeMethod("sgbm", Options())->Run(scene, kDisparities);
  const cv::Rect left(kDisparities, 0, 8, 120);  // OpenCV begins at 32, the next multiple of 16
  EXPECT_GT(cv::countNonZero(result.valid(left)), left.area() / 2);
  EXPECT_GT(cv::countNonZero(~result.valid), 0) << "of the occluded pixels";
}

TEST(SgbmMethod, TakesImagesOfEveryKind) {
  StereoScene scene = SmallScene();
  const MethodResult color = MakeMethod("hh", Options())->Run(scene, kDisparities);
  cv::cvtColor(scene.left, scene.left, cv::COLOR_BGR2BGRA);
  cv::cvtColor(scene.right, scene.right, cv::COLOR_BGR2BGRA);
  scene.left.convertTo(scene.left, CV_16U, 257);
  scene.right.convertTo(scene.right, CV_16U, 257);
  const MethodResult deep = MakeMethod("hh", Options())->Run(scene, kDisparities);
  EXPECT_EQ(cv::norm(color.dense, deep.dense, cv::NORM_INF), 0);
  scene.left = scene.left.colRange(0, 10);
  scene.right = scene.right.colRange(0, 10);
  EXPECT_EQ(MakeMethod("hh", Options())->Run(scene, kDisparities).dense.cols, 10);
}

TEST(SgbmMethod, LeavesTheThreadsOfOpenCvAsTheyWere) {
  const int before = cv::getNumThreads();
  Options options;
  options.threads = 1;
  MakeMethod("sgbm_3way", options)->Run(SmallScene(), kDisparities);
  EXPECT_EQ(cv::getNumThreads(), before);
}

}  // namespace
}  // namespace stereo_sgmp
