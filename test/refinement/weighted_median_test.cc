#include "refinement/weighted_median.h"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <cstdlib>
#include <utility>
#include <vector>

#include <gtest/gtest.h>
#include <hwy/targets.h>

namespace stereo_sgmp {
namespace {

constexpr int kRadius = 3;

struct Scene {
  cv::Mat image;
  cv::Mat confidence;
  cv::Mat disparity;
};

cv::Mat Filter(const Scene& scene, int threads = 1) {
  ThreadPool pool(threads);
  cv::Mat filtered;
  WeightedMedianFilter().Apply(scene.image, scene.confidence, scene.disparity, &filtered, &pool);
  return filtered;
}

int LargestDifference(const cv::Mat& image, cv::Point p, cv::Point q) {
  int largest = 0;
  const int channels = std::min(image.channels(), 3);
  for (int c = 0; c < channels; ++c) {
    const int a = image.ptr<std::uint8_t>(p.y)[p.x * image.channels() + c];
    const int b = image.ptr<std::uint8_t>(q.y)[q.x * image.channels() + c];
    largest = std::max(largest, std::abs(a - b));
  }
  return largest;
}

double RealWeight(int difference, float confidence) {
  return std::exp(-difference / 12.0) * (0.02 + static_cast<double>(confidence));
}

// The same with both factors rounded.
double RoundedWeight(int difference, float confidence) {
  return std::round(65535 * std::exp(-difference / 12.0)) *
         static_cast<double>(std::nearbyint(5 + 250 * confidence));
}

template <class Weight>
float ReferenceMedian(const Scene& scene, cv::Point p, Weight weight) {
  std::vector<std::pair<float, double>> window;
  double total = 0;
  for (int dy = -kRadius; dy <= kRadius; ++dy) {
    for (int dx = -kRadius; dx <= kRadius; ++dx) {
      const cv::Point q(std::clamp(p.x + dx, 0, scene.image.cols - 1),
                        std::clamp(p.y + dy, 0, scene.image.rows - 1));
      const double w = weight(LargestDifference(scene.image, p, q), scene.confidence.at<float>(q));
      window.emplace_back(scene.disparity.at<float>(q), w);
      total += w;
    }
  }
  std::sort(window.begin(), window.end());
  double sum = 0;
  for (const auto& [disparity, w] : window) {
    sum += w;
    if (2 * sum >= total) return disparity;
  }
  return window.back().first;
}

template <class Weight>
cv::Mat ReferenceFilter(const Scene& scene, Weight weight) {
  cv::Mat filtered(scene.disparity.size(), CV_32F);
  for (int y = 0; y < filtered.rows; ++y) {
    for (int x = 0; x < filtered.cols; ++x) {
      filtered.at<float>(y, x) = ReferenceMedian(scene, {x, y}, weight);
    }
  }
  return filtered;
}

// Disparities are in steps of a quarter of a pixel if there are to be ties.
Scene RandomScene(cv::Size size, int type, bool ties = false) {
  cv::RNG random(23);
  Scene scene = {cv::Mat(size, type), cv::Mat(size, CV_32F), cv::Mat(size, CV_32F)};
  random.fill(scene.image, cv::RNG::UNIFORM, 90, 140);
  random.fill(scene.confidence, cv::RNG::UNIFORM, 0.0, 1.0);
  random.fill(scene.disparity, cv::RNG::UNIFORM, -3.0, 12.0);
  if (!ties) return scene;
  scene.disparity.forEach<float>([](float& d, const int*) { d = std::round(4 * d) / 4; });
  return scene;
}

// Ten columns of disparity 5 beside ten of 9, of another colour, of confidence 1.
Scene StepScene(int color_difference) {
  const cv::Size size(20, 20);
  Scene scene = {cv::Mat(size, CV_8UC3, cv::Scalar::all(60)), cv::Mat(size, CV_32F, cv::Scalar(1)),
                 cv::Mat(size, CV_32F, cv::Scalar(5))};
  scene.image.colRange(10, 20).setTo(cv::Scalar(60, 60 + color_difference, 60));
  scene.disparity.colRange(10, 20).setTo(9);
  return scene;
}

TEST(WeightedMedianTest, EveryTargetEqualsTheDefinition) {
  for (const int type : {CV_8UC1, CV_8UC3, CV_8UC4}) {
    for (const cv::Size size : {cv::Size(1, 1), {3, 200}, {200, 3}, {37, 53}}) {
      for (const bool ties : {false, true}) {
        const Scene scene = RandomScene(size, type, ties);
        const cv::Mat expected = ReferenceFilter(scene, RoundedWeight);
        for (const auto target : hwy::SupportedAndGeneratedTargets()) {
          hwy::SetSupportedTargetsForTest(target);
          EXPECT_EQ(cv::norm(Filter(scene), expected, cv::NORM_INF), 0.0)
              << size << " type " << type << " " << hwy::TargetName(target);
        }
        hwy::SetSupportedTargetsForTest(0);
      }
    }
  }
}

TEST(WeightedMedianTest, RoundedWeightsHardlyEverChooseAnotherDisparity) {
  const Scene scene = RandomScene({120, 80}, CV_8UC3);
  const cv::Mat difference = Filter(scene) != ReferenceFilter(scene, RealWeight);
  EXPECT_LT(cv::countNonZero(difference), 0.01 * static_cast<double>(difference.total()));
}

TEST(WeightedMedianTest, ExactForDisparitiesOfVeryDifferentMagnitude) {
  Scene scene = RandomScene({40, 30}, CV_8UC1);
  scene.disparity.forEach<float>(
      [](float& d, const int*) { d = std::copysign(std::exp(8 * d), d); });
  EXPECT_EQ(cv::norm(Filter(scene), ReferenceFilter(scene, RoundedWeight), cv::NORM_INF), 0.0);
  float d = 1.0f;
  for (int i = 0; i < 1200; ++i) {  // neighbouring floats, between which there is no middle
    scene.disparity.at<float>(i / 40, i * 7 % 40) = d;
    if (i % 100 == 0) d = std::nextafter(d, 2.0f);
  }
  EXPECT_EQ(cv::norm(Filter(scene), ReferenceFilter(scene, RoundedWeight), cv::NORM_INF), 0.0);
}

TEST(WeightedMedianTest, ThreadsDoNotMatter) {
  for (const cv::Size size : {cv::Size(1, 1), {3, 200}, {37, 53}}) {
    const Scene scene = RandomScene(size, CV_8UC3);
    EXPECT_EQ(cv::norm(Filter(scene, 1), Filter(scene, 3), cv::NORM_INF), 0.0) << size;
  }
}

TEST(WeightedMedianTest, EdgesOfTheImageKeepThinStructures) {
  Scene scene = StepScene(80);
  scene.image.colRange(14, 15).setTo(cv::Scalar(255, 60, 60));  // one seventh of the window
  scene.disparity.colRange(14, 15).setTo(3);
  EXPECT_EQ(cv::norm(Filter(scene), scene.disparity, cv::NORM_INF), 0.0);
  scene.image.setTo(60);
  EXPECT_EQ(Filter(scene).at<float>(10, 14), 9.0f);
}

TEST(WeightedMedianTest, StepsMoveToTheEdgeOfTheImage) {
  Scene scene = StepScene(40);
  scene.disparity.setTo(5);
  scene.disparity.colRange(11, 20).setTo(9);  // a column late
  EXPECT_EQ(cv::norm(Filter(scene), StepScene(40).disparity, cv::NORM_INF), 0.0);
}

TEST(WeightedMedianTest, OutliersOfLowConfidenceGo) {
  Scene scene = StepScene(80);
  const cv::Rect outlier(2, 8, 4, 7);  // more than half of many windows
  scene.disparity(outlier).setTo(70);
  EXPECT_GT(cv::countNonZero(Filter(scene) == 70), 0);
  scene.confidence(outlier).setTo(0);
  EXPECT_EQ(cv::norm(Filter(scene), StepScene(80).disparity, cv::NORM_INF), 0.0);
}

TEST(WeightedMedianTest, WithoutConfidenceAllCountAlike) {
  Scene scene = RandomScene({30, 20}, CV_8UC3);
  scene.confidence.setTo(0);
  const cv::Mat filtered = Filter(scene);
  scene.confidence.setTo(0.6f);
  EXPECT_EQ(cv::norm(filtered, Filter(scene), cv::NORM_INF), 0.0);
}

TEST(WeightedMedianTest, FiltersInPlaceAndIsReusedForAnotherSizeAndType) {
  ThreadPool pool(2);
  WeightedMedianFilter filter;
  for (const cv::Size size : {cv::Size(40, 30), {9, 50}, {40, 30}}) {
    for (const int type : {CV_8UC3, CV_8UC1}) {
      const Scene scene = RandomScene(size, type);
      cv::Mat disparity = scene.disparity.clone();
      filter.Apply(scene.image, scene.confidence, disparity, &disparity, &pool);
      EXPECT_EQ(cv::norm(disparity, Filter(scene), cv::NORM_INF), 0.0);
    }
  }
}

}  // namespace
}  // namespace stereo_sgmp
