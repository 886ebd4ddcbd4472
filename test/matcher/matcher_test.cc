#include "stereo_sgmp/matcher.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <chrono>
#include <cmath>
#include <ctime>
#include <opencv2/imgproc.hpp>
#include <stdexcept>
#include <string>
#include <thread>

#include "scene/generated_scene.h"
#include "stereo_sgmp/presets.h"

namespace stereo_sgmp {
namespace {

using ::testing::HasSubstr;

bool SameBits(const cv::Mat& a, const cv::Mat& b) {
  if (a.empty() && b.empty()) return true;
  if (a.size() != b.size() || a.type() != b.type()) return false;
  for (int y = 0; y < a.rows; ++y) {
    if (!std::equal(a.ptr(y), a.ptr(y) + static_cast<std::size_t>(a.cols) * a.elemSize(),
                    b.ptr(y))) {
      return false;
    }
  }
  return true;
}

void ExpectSameBits(const MatchResult& a, const MatchResult& b) {
  EXPECT_TRUE(SameBits(a.raw, b.raw));
  EXPECT_TRUE(SameBits(a.dense, b.dense));
  EXPECT_TRUE(SameBits(a.reason, b.reason));
  EXPECT_TRUE(SameBits(a.confidence, b.confidence));
  EXPECT_TRUE(SameBits(a.uncertainty, b.uncertainty));
  EXPECT_TRUE(SameBits(a.priors.labels, b.priors.labels));
}

GeneratedScene SmallRoom() { return MakeScene(SceneKind::kRoom, {150, 101}, 40, {}, 3); }

Options SmallOptions(const std::string& preset = "default") {
  Options options = PresetOptions(preset);
  options.num_disparities = 40;
  return options;
}

MatchResult MatchOnce(const Options& options, const cv::Mat& left, const cv::Mat& right) {
  Matcher matcher(options);
  MatchResult result;
  matcher.Match(left, right, &result);
  return result;
}

std::string ErrorOf(const Options& options, const cv::Mat& left, const cv::Mat& right) {
  try {
    MatchOnce(options, left, right);
  } catch (const std::exception& error) {
    return error.what();
  }
  return "no error";
}

class PresetTest : public ::testing::TestWithParam<std::string> {};

TEST_P(PresetTest, ResultsDoNotDependOnThreadsOrRuns) {
  const GeneratedScene scene = SmallRoom();
  Options options = SmallOptions(GetParam());
  options.threads = 1;
  const MatchResult one = MatchOnce(options, scene.left, scene.right);
  for (const int threads : {1, 2, 5}) {
    SCOPED_TRACE(threads);
    options.threads = threads;
    ExpectSameBits(MatchOnce(options, scene.left, scene.right), one);
  }
}

TEST_P(PresetTest, AMatcherServesSizesAndVariantsInAnyOrder) {
  const GeneratedScene scene = SmallRoom();
  const GeneratedScene other = MakeScene(SceneKind::kFence, {97, 64}, 40, {}, 4);
  Options options = SmallOptions(GetParam());
  options.alignment.mode = AlignmentMode::kOff;  // a rig does not change its size
  Matcher matcher(options);
  MatchResult result;
  for (const Variant variant : {Variant::kEpv, Variant::kSgm, Variant::kEpi}) {
    options.prior.variant = variant;
    matcher.SetOptions(options);
    for (const GeneratedScene* pair : {&scene, &other, &scene}) {
      matcher.Match(pair->left, pair->right, &result);
      ExpectSameBits(result, MatchOnce(options, pair->left, pair->right));
    }
  }
}

TEST_P(PresetTest, TinyImagesAreMatched) {
  for (const cv::Size size : {cv::Size(1, 1), cv::Size(1, 9), cv::Size(9, 1), cv::Size(6, 5)}) {
    SCOPED_TRACE(::testing::Message() << size.width << "x" << size.height);
    Options options = SmallOptions(GetParam());
    options.num_disparities = size.width;
    cv::Mat image(size, CV_8UC3);
    cv::randu(image, 0, 255);
    const MatchResult result = MatchOnce(options, image, image);
    EXPECT_EQ(result.dense.size(), size);
    EXPECT_TRUE(cv::checkRange(result.dense));
    EXPECT_TRUE(cv::checkRange(result.confidence, true, nullptr, 0.0, 1.0 + 1e-6));
  }
}

INSTANTIATE_TEST_SUITE_P(All, PresetTest, ::testing::Values("default", "quality", "paper"));

TEST(MatcherTest, NothingWorksBetweenFrames) {
  const GeneratedScene scene = SmallRoom();
  Options options = SmallOptions();
  options.threads = 3;
  options.pin_threads = true;
  options.alignment.mode = AlignmentMode::kOff;  // or the first frames' fit may still be going on
  Matcher matcher(options);
  MatchResult result;
  for (int i = 0; i < 3; ++i) matcher.Match(scene.left, scene.right, &result);
  std::this_thread::sleep_for(std::chrono::milliseconds(50));
  const std::clock_t before = std::clock();  // of all threads
  std::this_thread::sleep_for(std::chrono::milliseconds(200));
  EXPECT_LT(std::clock() - before, CLOCKS_PER_SEC / 100);
}

double ShareOfErrors(const cv::Mat& disparity, const cv::Mat& truth) {
  const cv::Mat wrong = cv::abs(disparity - truth) > 1.0;
  return cv::countNonZero(wrong) / static_cast<double>(wrong.total());
}

// Its surfaces end below 60 of the 192 disparities that WideOptions search, as the coarse pass
// sees.
GeneratedScene FarSurface() { return MakeScene(SceneKind::kCurved, {320, 240}, 60, {}, 3); }

Options WideOptions() {
  Options options;
  options.num_disparities = 192;
  return options;
}

void ExpectSearchedNoFurtherThanFarSurface(Options options) {
  const GeneratedScene scene = FarSurface();
  const MatchResult narrow = MatchOnce(options, scene.left, scene.right);
  EXPECT_EQ(narrow.statistics.searched_disparities, 64);
  options.narrow_range = false;
  const MatchResult full = MatchOnce(options, scene.left, scene.right);
  EXPECT_EQ(full.statistics.searched_disparities, 192);
  EXPECT_LE(ShareOfErrors(narrow.dense, scene.disparity),
            1.01 * ShareOfErrors(full.dense, scene.disparity));
}

TEST(MatcherTest, SearchesNoFurtherThanTheSceneComes) {
  ExpectSearchedNoFurtherThanFarSurface(WideOptions());
}

// Nothing else needs the coarse pass then.
TEST(MatcherTest, SearchesNoFurtherWithCensusAndWithoutPrior) {
  Options options = WideOptions();
  options.cost.kind = CostKind::kCensus;
  options.prior.variant = Variant::kSgm;
  ExpectSearchedNoFurtherThanFarSurface(options);
}

// What is given may know of surfaces that the coarse pass does not see.
TEST(MatcherTest, SearchesTheWholeRangeWithAGivenSurface) {
  const GeneratedScene scene = FarSurface();
  Options options = WideOptions();
  options.prior.variant = Variant::kGs;
  MatchInputs inputs;
  inputs.surface = scene.disparity;
  MatchResult result;
  Matcher(options).Match(scene.left, scene.right, inputs, &result);
  EXPECT_EQ(result.statistics.searched_disparities, 192);
}

TEST(MatcherTest, SearchesTheWholeRangeOfGivenCosts) {
  const GeneratedScene scene = FarSurface();
  Options options = WideOptions();
  CostVolume volume;
  volume.width = scene.left.cols;
  volume.height = scene.left.rows;
  volume.disparities = options.num_disparities;
  volume.costs.resize(scene.left.total() * static_cast<std::size_t>(volume.disparities), 100);
  MatchInputs inputs;
  inputs.costs = &volume;
  MatchResult result;
  Matcher(options).Match(scene.left, scene.right, inputs, &result);
  EXPECT_EQ(result.statistics.searched_disparities, 192);
}

TEST(MatcherTest, StatisticsDescribeTheResult) {
  const GeneratedScene scene = SmallRoom();
  const MatchResult result = MatchOnce(SmallOptions(), scene.left, scene.right);
  const MatchStatistics& statistics = result.statistics;
  double sum = 0.0;
  for (const StageTime& stage : statistics.stages) sum += stage.ms;
  EXPECT_NEAR(sum, statistics.frame_ms, 1e-6);
  EXPECT_EQ(statistics.planes, static_cast<int>(result.priors.planes.size()));
  const int valid = static_cast<int>(result.reason.total()) - cv::countNonZero(result.reason);
  EXPECT_EQ(statistics.reasons[0], valid);
  EXPECT_NEAR(statistics.density, valid / static_cast<double>(result.reason.total()), 1e-9);
}

TEST(MatcherTest, FilteredDisparityIsDenseWhereValid) {
  const GeneratedScene scene = SmallRoom();
  const MatchResult result = MatchOnce(SmallOptions(), scene.left, scene.right);
  cv::Mat filtered;
  FilteredDisparity(result, -1.0F, &filtered);
  int invalid = 0;
  for (int y = 0; y < filtered.rows; ++y) {
    for (int x = 0; x < filtered.cols; ++x) {
      const bool valid = result.reason.at<std::uint8_t>(y, x) == 0;
      EXPECT_EQ(filtered.at<float>(y, x), valid ? result.dense.at<float>(y, x) : -1.0F);
      if (!valid) ++invalid;
    }
  }
  EXPECT_GT(invalid, 0);
}

TEST(MatcherTest, AShiftOfTheRightImageShiftsTheDisparityRange) {
  const GeneratedScene scene = SmallRoom();
  Options options = SmallOptions();
  options.alignment.mode = AlignmentMode::kOff;
  const MatchResult straight = MatchOnce(options, scene.left, scene.right);
  // Moving the right image by 25 columns to the right takes 25 off each disparity.
  constexpr int kShift = 25;
  cv::Mat left(scene.left.rows, scene.left.cols + 2 * kShift, CV_8UC3, cv::Scalar::all(90));
  cv::Mat right = left.clone();
  scene.left.copyTo(left(cv::Rect(kShift, 0, scene.left.cols, scene.left.rows)));
  scene.right.copyTo(right(cv::Rect(2 * kShift, 0, scene.left.cols, scene.left.rows)));
  options.min_disparity = -kShift;
  const MatchResult shifted = MatchOnce(options, left, right);
  int same = 0;
  const cv::Rect inner(60, 5, 80, 90);
  for (int y = inner.y; y < inner.br().y; ++y) {
    for (int x = inner.x; x < inner.br().x; ++x) {
      const float expected = straight.dense.at<float>(y, x) - kShift;
      if (std::abs(shifted.dense.at<float>(y, x + kShift) - expected) < 1.0F) ++same;
    }
  }
  EXPECT_GT(same, inner.area() * 9 / 10);
}

TEST(MatcherTest, SixteenBitImagesGiveTheDisparitiesOfEightBitOnes) {
  const GeneratedScene scene = SmallRoom();
  cv::Mat left;
  cv::Mat right;
  // 12 bits in 16, with the top value present so that the scale is known.
  scene.left.convertTo(left, CV_16U, 16.0);
  scene.right.convertTo(right, CV_16U, 16.0);
  left.at<cv::Vec3w>(0, 0) = cv::Vec3w(4080, 4080, 4080);
  cv::Mat left8 = scene.left.clone();
  left8.at<cv::Vec3b>(0, 0) = cv::Vec3b(255, 255, 255);
  ExpectSameBits(MatchOnce(SmallOptions(), left, right),
                 MatchOnce(SmallOptions(), left8, scene.right));
}

TEST(MatcherTest, BadInputIsNamedBeforeWorkStarts) {
  const cv::Mat image(20, 30, CV_8UC1, cv::Scalar(7));
  Options options;
  options.num_disparities = 31;
  EXPECT_THAT(ErrorOf(options, image, image), HasSubstr("num_disparities is 31"));
  options.num_disparities = 16;
  EXPECT_THAT(ErrorOf(options, image, cv::Mat()), HasSubstr("right image is empty"));
  options.prior.coarse_factor = -1;
  EXPECT_THAT(ErrorOf(options, image, image), HasSubstr("prior/coarse_factor"));
}

TEST(MatcherTest, AVolumeThatDoesNotFitIsRefusedBeforeWorkStarts) {
  Options options;
  options.num_disparities = 2048;
  options.aggregation.path_costs = PathCosts::kFull;
  const cv::Mat image = cv::Mat::zeros(8192, 8192, CV_8UC1);
  EXPECT_GT(EstimateMemory(options, image.size()), std::size_t{8192} * 8192 * 2048 * 2);
  EXPECT_THAT(ErrorOf(options, image, image), HasSubstr("lower num_disparities"));
}

TEST(MatcherTest, ALimitOfMemoryChangesNothingButTheMemory) {
  const GeneratedScene scene = MakeScene(SceneKind::kRoom, {640, 300}, 64, {}, 2);
  for (const char* preset : {"default", "quality"}) {
    SCOPED_TRACE(preset);
    Options options = PresetOptions(preset);
    options.num_disparities = 64;
    options.alignment.mode = AlignmentMode::kOff;
    const MatchResult unlimited = MatchOnce(options, scene.left, scene.right);
    constexpr double kMegabyte = 1024.0 * 1024.0;
    const double all = static_cast<double>(EstimateMemory(options, scene.left.size()));
    options.memory_limit = static_cast<int>(all / kMegabyte) - 4;  // a third of S
    const double limited = static_cast<double>(EstimateMemory(options, scene.left.size()));
    EXPECT_LE(limited, options.memory_limit * kMegabyte);
    ExpectSameBits(MatchOnce(options, scene.left, scene.right), unlimited);
    options.memory_limit = 1;
    EXPECT_THAT(ErrorOf(options, scene.left, scene.right),
                HasSubstr("memory_limit is 1 MB; raise it"));
  }
}

TEST(MatcherTest, TheMemoryIsThatOfTheVariantAndOfOwnCosts) {
  const cv::Size size(400, 300);
  const std::size_t pixels = 400 * 300;
  Options options;
  options.cost.kind = CostKind::kNcc;
  options.prior.variant = Variant::kSgm;
  const std::size_t plain = EstimateMemory(options, size);
  const CostVolume costs;
  MatchInputs inputs;
  inputs.costs = &costs;
  EXPECT_LE(EstimateMemory(options, size, inputs) + pixels * 128, plain);
  options.prior.variant = Variant::kMw;
  EXPECT_GT(EstimateMemory(options, size), plain);
  options.prior.variant = Variant::kGs;
  EXPECT_EQ(EstimateMemory(options, size), plain + pixels * 2);
  options.prior.variant = Variant::kGni;
  // A float and a number per pixel, three times.
  EXPECT_EQ(EstimateMemory(options, size), plain + pixels * 24);
  options.prior.variant = Variant::kGnv;
  // A float, rounded too, and 40 bytes per pixel of a coarse image of half the size.
  EXPECT_EQ(EstimateMemory(options, size), plain + pixels * (24 + 27) + pixels / 4 * 40);
}

TEST(MatcherTest, TheMemoryHasCostsThatAreKeptBetweenSweeps) {
  const cv::Size size(640, 480);
  Options options;
  options.num_disparities = 64;
  const std::size_t kept = EstimateMemory(options, size);
  const std::size_t volume = std::size_t{640} * 480 * 64;
  options.memory_limit = 1000;
  EXPECT_LT(EstimateMemory(options, size) + volume, kept) << "with a limit, nothing is kept";
  options.memory_limit = 0;
  const auto of_disparities = [&](int disparities) {
    options.num_disparities = disparities;
    return EstimateMemory(options, cv::Size(2048, 1536));
  };
  EXPECT_LT(of_disparities(192), of_disparities(128)) << "large volumes are not kept";
}

TEST(MatcherTest, AnErrorLeavesTheMatcherUsable) {
  const GeneratedScene scene = SmallRoom();
  const Options options = SmallOptions();
  Matcher matcher(options);
  MatchResult result;
  EXPECT_THROW(matcher.Match(scene.left, cv::Mat(), &result), std::invalid_argument);
  Options wrong = options;
  wrong.num_disparities = -1;
  EXPECT_THROW(matcher.SetOptions(wrong), std::invalid_argument);
  EXPECT_EQ(matcher.options().num_disparities, options.num_disparities);
  matcher.Match(scene.left, scene.right, &result);
  ExpectSameBits(result, MatchOnce(options, scene.left, scene.right));
}

TEST(MatcherTest, UniformImagesGiveNoConfidence) {
  const cv::Mat image(60, 80, CV_8UC1, cv::Scalar(100));
  Options options = SmallOptions();
  const MatchResult result = MatchOnce(options, image, image);
  EXPECT_TRUE(cv::checkRange(result.dense));
  EXPECT_LT(result.statistics.density, 0.05);
}

}  // namespace
}  // namespace stereo_sgmp
