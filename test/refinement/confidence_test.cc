#include "refinement/confidence.h"

#include <algorithm>
#include <cstdlib>
#include <utility>
#include <vector>

#include <gtest/gtest.h>

#include "refinement/left_right.h"
#include "winner_maps.h"

namespace stereo_sgmp {
namespace {

constexpr int kP1 = 100;

AggregationOptions OptionsOf(PathScheme scheme) {
  AggregationOptions aggregation;
  aggregation.scheme = scheme;
  aggregation.p1 = kP1;
  return aggregation;
}

cv::Mat ConfidenceOf(const WinnerMap& map, ConfidenceMeasure measure,
                     PathScheme scheme = PathScheme::kEight) {
  const int rows = map.shape.height;
  cv::Mat left_right(map.winner.size(), CV_16U);
  LeftRightDifferences(map, 0, rows, &left_right);
  cv::Mat confidence(map.winner.size(), CV_32F);
  const int middle = rows / 2;
  const AggregationOptions aggregation = OptionsOf(scheme);
  ComputeConfidence(map, left_right, measure, aggregation, middle, rows, &confidence);
  ComputeConfidence(map, left_right, measure, aggregation, 0, middle, &confidence);
  return confidence;
}

cv::Mat PeakConfidenceOf(const WinnerMap& map) {
  return ConfidenceOf(map, ConfidenceMeasure::kPeakDifference);
}

// The measure as its definition reads.
double PeakMeasure(const WinnerMap& map, int y, int x) {
  double sum = 0.0;
  int count = 0;
  for (int v = std::max(y - 2, 0); v <= std::min(y + 2, map.shape.height - 1); ++v) {
    for (int u = std::max(x - 2, 0); u <= std::min(x + 2, map.shape.width - 1); ++u) {
      if (map.second(v, u) != WinnerMap::kNone) sum += map.second(v, u) - map.cost(v, u);
      ++count;
    }
  }
  const int x_right = x - map.shape.min_disparity - map.winner(y, x);
  int difference = 10;
  if (x_right >= 0 && x_right < map.shape.width &&
      map.right_winner(y, x_right) != WinnerMap::kNone) {
    difference = std::min(10, std::abs(map.right_winner(y, x_right) - map.winner(y, x)));
  }
  return sum / count - 100.0 * difference;
}

TEST(ConfidenceTest, SortsPixelsAsTheMeasureDoes) {
  for (const VolumeShape& shape :
       {VolumeShape{40, 23, 12, 0}, VolumeShape{17, 3, 8, -4}, VolumeShape{9, 9, 3, 2}}) {
    const WinnerMap map = RandomWinnerMap(shape, 7);
    const cv::Mat confidence = PeakConfidenceOf(map);
    std::vector<std::pair<double, float>> pixels;
    for (int y = 0; y < shape.height; ++y) {
      for (int x = 0; x < shape.width; ++x) {
        pixels.emplace_back(PeakMeasure(map, y, x), confidence.at<float>(y, x));
      }
    }
    std::sort(pixels.begin(), pixels.end());
    for (std::size_t i = 1; i < pixels.size(); ++i) {
      if (pixels[i].first - pixels[i - 1].first < 1e-3) continue;  // rounding may order these
      EXPECT_GT(pixels[i].second, pixels[i - 1].second) << pixels[i].first;
    }
    EXPECT_GT(pixels.front().second, 0.0f);
    EXPECT_LT(pixels.back().second, 1.0f);
  }
}

TEST(ConfidenceTest, IsTheAverageOfTheNeighbourhood) {
  WinnerMap map = UniformWinnerMap({9, 9, 20, 0}, 0);
  map.second(4, 4) = 3000;
  const cv::Mat confidence = PeakConfidenceOf(map);
  const float around = confidence.at<float>(4, 4);
  EXPECT_EQ(confidence.at<float>(2, 2), around);
  EXPECT_EQ(confidence.at<float>(6, 6), around);
  EXPECT_LT(confidence.at<float>(1, 4), around);
  EXPECT_LT(confidence.at<float>(4, 7), around);
  EXPECT_EQ(confidence.at<float>(1, 4), confidence.at<float>(0, 0));  // no darker at the border
}

TEST(ConfidenceTest, FallsWithLeftRightDifferenceUpToTen) {
  WinnerMap map = UniformWinnerMap({60, 1, 40, 0}, 20);
  const auto confidence_at_difference = [&](int difference) {
    map.right_winner(0, 30) = static_cast<std::uint16_t>(20 - difference);
    return PeakConfidenceOf(map).at<float>(0, 50);
  };
  EXPECT_LT(confidence_at_difference(1), confidence_at_difference(0));
  EXPECT_LT(confidence_at_difference(10), confidence_at_difference(9));
  EXPECT_EQ(confidence_at_difference(15), confidence_at_difference(10));
  const float worst = confidence_at_difference(10);
  EXPECT_EQ(PeakConfidenceOf(map).at<float>(0, 0), worst);  // its match lies outside
  map.right_winner(0, 30) = WinnerMap::kNone;
  EXPECT_EQ(PeakConfidenceOf(map).at<float>(0, 50), worst);
}

TEST(ConfidenceTest, LargeDifferencesStayInOrder) {
  float last = 0.0f;
  for (const int second : {500, 1000, 2000, 4000, 8000, 16000, 60000}) {
    WinnerMap map = UniformWinnerMap({1, 1, 20, 0}, 0);
    map.second = static_cast<std::uint16_t>(second);
    const float confidence = PeakConfidenceOf(map).at<float>(0, 0);
    EXPECT_GT(confidence, last);
    EXPECT_LT(confidence, 1.0f);
    last = confidence;
  }
}

TEST(ConfidenceTest, UncertaintyIsMeasuredInPenaltiesOfEightPaths) {
  WinnerMap map = UniformWinnerMap({3, 1, 20, 0}, 5);
  map.uncertainty(0, 1) = 8 * kP1;
  map.uncertainty(0, 2) = 24 * kP1;
  const cv::Mat confidence = ConfidenceOf(map, ConfidenceMeasure::kUncertainty);
  EXPECT_EQ(confidence.at<float>(0, 0), 1.0f);
  EXPECT_EQ(confidence.at<float>(0, 1), 0.5f);
  EXPECT_EQ(confidence.at<float>(0, 2), 0.25f);
}

TEST(ConfidenceTest, FourPathsAreWorthAsMuchAsEight) {
  WinnerMap four = RandomWinnerMap({31, 13, 10, 0}, 3);
  const auto halve = [](std::uint16_t cost) { return static_cast<std::uint16_t>(cost / 2); };
  for (int y = 0; y < four.shape.height; ++y) {
    for (int x = 0; x < four.shape.width; ++x) {
      four.cost(y, x) = halve(four.cost(y, x));
      if (four.second(y, x) != WinnerMap::kNone) four.second(y, x) = halve(four.second(y, x));
      four.uncertainty(y, x) = halve(four.uncertainty(y, x));
    }
  }
  WinnerMap eight = four;  // shares its images
  for (cv::Mat_<std::uint16_t>* costs : {&eight.cost, &eight.second, &eight.uncertainty}) {
    *costs = costs->clone();
    for (std::uint16_t& cost : *costs) {
      if (cost != WinnerMap::kNone) cost = static_cast<std::uint16_t>(2 * cost);
    }
  }
  for (const ConfidenceMeasure measure :
       {ConfidenceMeasure::kPeakDifference, ConfidenceMeasure::kUncertainty}) {
    const cv::Mat expected = ConfidenceOf(eight, measure);
    const cv::Mat confidence = ConfidenceOf(four, measure, PathScheme::kFour);
    EXPECT_EQ(cv::norm(expected, confidence, cv::NORM_INF), 0.0);
  }
}

TEST(ConfidenceTest, DoesNotDependOnHowRowsAreDivided) {
  const WinnerMap map = RandomWinnerMap({31, 13, 10, 0}, 3);
  cv::Mat left_right(map.winner.size(), CV_16U);
  LeftRightDifferences(map, 0, 13, &left_right);
  for (const ConfidenceMeasure measure :
       {ConfidenceMeasure::kPeakDifference, ConfidenceMeasure::kUncertainty}) {
    cv::Mat one_by_one(map.winner.size(), CV_32F);
    for (int y = 0; y < 13; ++y) {
      ComputeConfidence(map, left_right, measure, OptionsOf(PathScheme::kEight), y, y + 1,
                        &one_by_one);
    }
    EXPECT_EQ(cv::norm(one_by_one, ConfidenceOf(map, measure), cv::NORM_INF), 0.0);
  }
}

TEST(ConfidenceTest, TinyImagesAndRanges) {
  for (const VolumeShape& shape :
       {VolumeShape{1, 1, 1, 0}, VolumeShape{1, 5, 2, 0}, VolumeShape{6, 1, 3, 0}}) {
    const cv::Mat confidence = PeakConfidenceOf(RandomWinnerMap(shape, 5));
    EXPECT_EQ(confidence.size(), cv::Size(shape.width, shape.height));
    EXPECT_TRUE(cv::checkRange(confidence, true, nullptr, 0.0, 1.0));
  }
}

TEST(ConfidenceTest, UncertaintyImageHoldsCostUnits) {
  WinnerMap map = UniformWinnerMap({2, 1, 20, 0}, 5);
  map.uncertainty(0, 1) = 1234;
  cv::Mat uncertainty(1, 2, CV_32F);
  UncertaintyImage(map, 0, 1, &uncertainty);
  EXPECT_EQ(uncertainty.at<float>(0, 0), 0.0f);
  EXPECT_EQ(uncertainty.at<float>(0, 1), 1234.0f);
}

}  // namespace
}  // namespace stereo_sgmp
