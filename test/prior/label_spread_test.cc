#include "prior/label_spread.h"

#include <algorithm>
#include <cstdint>
#include <cstdlib>
#include <limits>
#include <stdexcept>
#include <vector>

#include <gtest/gtest.h>

namespace stereo_sgmp {
namespace {

constexpr int kReach = 150;
constexpr int kUnreached = std::numeric_limits<int>::max();

cv::Mat NoLabels(cv::Size size) { return cv::Mat(size, CV_16SC1, cv::Scalar(-1)); }

cv::Mat Spread(const cv::Mat& image, const cv::Mat& labels) {
  LabelSpreader spreader;
  cv::Mat spread = labels.clone();
  spreader.Spread(image, &spread);
  return spread;
}

std::vector<int> RowOf(const cv::Mat& labels, int y) {
  return {labels.ptr<std::int16_t>(y), labels.ptr<std::int16_t>(y) + labels.cols};
}

int StepCost(const cv::Mat& image, cv::Point a, cv::Point b) {
  int largest = 0;
  for (int c = 0; c < std::min(image.channels(), 3); ++c) {
    const int difference = image.ptr(a.y, a.x)[c] - image.ptr(b.y, b.x)[c];
    largest = std::max(largest, std::abs(difference));
  }
  return 2 + largest;
}

// Cost of the cheapest path from any pixel of `label`: steps are relaxed until none helps.
cv::Mat_<int> CostsFrom(const cv::Mat& image, const cv::Mat& labels, int label) {
  cv::Mat_<int> cost(labels.size(), kUnreached);
  cost.setTo(0, labels == label);
  bool changed = true;
  while (changed) {
    changed = false;
    for (int y = 0; y < cost.rows; ++y) {
      for (int x = 0; x < cost.cols; ++x) {
        if (cost(y, x) == kUnreached) continue;
        for (const cv::Point to :
             {cv::Point(x + 1, y), cv::Point(x - 1, y), cv::Point(x, y + 1), cv::Point(x, y - 1)}) {
          if (!cv::Rect(0, 0, cost.cols, cost.rows).contains(to)) continue;
          const int through = cost(y, x) + StepCost(image, {x, y}, to);
          if (through >= cost(to)) continue;
          cost(to) = through;
          changed = true;
        }
      }
    }
  }
  return cost;
}

class LabelSpreadOver : public testing::TestWithParam<int> {};  // channels

TEST_P(LabelSpreadOver, EachPixelTakesALabelThatACheapestPathEndsAt) {
  cv::RNG random(5);
  cv::Mat image(23, 31, CV_8UC(GetParam()));
  random.fill(image, cv::RNG::UNIFORM, 0, 70);
  cv::Mat labels = NoLabels(image.size());
  constexpr int kLabels = 4;
  for (int label = 0; label < kLabels; ++label) {
    // Two pixels each, all in one half: some of the rest is out of reach.
    for (int i = 0; i < 2; ++i) {
      labels.at<std::int16_t>(random.uniform(0, 23), random.uniform(0, 15)) =
          static_cast<std::int16_t>(label);
    }
  }
  const cv::Mat spread = Spread(image, labels);
  std::vector<cv::Mat_<int>> costs;
  for (int label = 0; label < kLabels; ++label) costs.push_back(CostsFrom(image, labels, label));
  int reached = 0;
  for (int y = 0; y < image.rows; ++y) {
    for (int x = 0; x < image.cols; ++x) {
      int cheapest = kUnreached;
      for (const cv::Mat_<int>& cost : costs) cheapest = std::min(cheapest, cost(y, x));
      const int label = spread.at<std::int16_t>(y, x);
      ASSERT_EQ(label >= 0, cheapest <= kReach) << "x " << x << " y " << y;
      if (label < 0) continue;
      ++reached;
      ASSERT_EQ(costs[static_cast<std::size_t>(label)](y, x), cheapest) << "x " << x << " y " << y;
    }
  }
  EXPECT_GT(reached, 50);
  EXPECT_LT(reached, image.rows * image.cols);
}

INSTANTIATE_TEST_SUITE_P(Channels, LabelSpreadOver, testing::Values(1, 3, 4));

TEST(LabelSpread, FlowsOverUniformColourAsFarAsItReaches) {
  const cv::Mat image(3, 200, CV_8UC3, cv::Scalar(9, 90, 200));
  cv::Mat labels = NoLabels(image.size());
  labels.at<std::int16_t>(1, 0) = 7;
  const cv::Mat spread = Spread(image, labels);
  for (int x = 0; x < 200; ++x) {
    EXPECT_EQ(spread.at<std::int16_t>(1, x), x <= kReach / 2 ? 7 : -1) << x;
    EXPECT_EQ(spread.at<std::int16_t>(0, x), x < kReach / 2 ? 7 : -1) << x;
  }
}

TEST(LabelSpread, StepsOverAnEdgeWithinReachOnly) {
  for (const int edge : {kReach - 2, kReach - 1}) {
    cv::Mat image(1, 2, CV_8UC3, cv::Scalar(20, 20, 20));
    image.at<cv::Vec3b>(0, 1)[1] = static_cast<std::uint8_t>(20 + edge);
    cv::Mat labels = NoLabels(image.size());
    labels.at<std::int16_t>(0, 0) = 3;
    EXPECT_EQ(Spread(image, labels).at<std::int16_t>(0, 1), edge == kReach - 2 ? 3 : -1) << edge;
  }
}

TEST(LabelSpread, AnEdgeSeparatesLabelsHoweverNearTheyStart) {
  cv::Mat image(1, 40, CV_8UC1, cv::Scalar(50));
  image.colRange(11, 40).setTo(150);
  cv::Mat labels = NoLabels(image.size());
  labels.at<std::int16_t>(0, 10) = 1;
  labels.at<std::int16_t>(0, 39) = 2;
  std::vector<int> expected(40, 2);
  std::fill(expected.begin(), expected.begin() + 11, 1);
  EXPECT_EQ(RowOf(Spread(image, labels), 0), expected);
}

TEST(LabelSpread, OnUniformColourTheEarlierPixelWinsATie) {
  const cv::Mat image(5, 5, CV_8UC1, cv::Scalar(0));
  cv::Mat labels = NoLabels(image.size());
  labels.at<std::int16_t>(0, 4) = 9;
  labels.at<std::int16_t>(4, 0) = 2;
  const cv::Mat spread = Spread(image, labels);
  for (int i = 0; i < 5; ++i) EXPECT_EQ(spread.at<std::int16_t>(i, i), 9) << i;
  EXPECT_EQ(spread.at<std::int16_t>(3, 2), 2);
}

TEST(LabelSpread, LabelsThatAreThereStay) {
  const cv::Mat image(2, 3, CV_8UC1, cv::Scalar(0));
  const cv::Mat labels = (cv::Mat_<std::int16_t>(2, 3) << 0, 1, 2, 5, 4, 3);
  EXPECT_EQ(cv::norm(Spread(image, labels), labels, cv::NORM_INF), 0.0);
}

TEST(LabelSpread, WithoutLabelsNothingSpreads) {
  const cv::Mat image(6, 7, CV_8UC1, cv::Scalar(0));
  EXPECT_EQ(cv::countNonZero(Spread(image, NoLabels(image.size())) != -1), 0);
}

TEST(LabelSpread, ForgetsTheLastImage) {
  LabelSpreader spreader;
  cv::Mat labels(9, 9, CV_16SC1, cv::Scalar(1));
  spreader.Spread(cv::Mat(9, 9, CV_8UC1, cv::Scalar(0)), &labels);
  const cv::Mat image(4, 90, CV_8UC1, cv::Scalar(0));
  cv::Mat first = NoLabels(image.size());
  first.at<std::int16_t>(2, 1) = 6;
  const cv::Mat expected = Spread(image, first);
  spreader.Spread(image, &first);
  EXPECT_EQ(cv::norm(first, expected, cv::NORM_INF), 0.0);
}

TEST(LabelSpread, RefusesWhatDoesNotFit) {
  const cv::Mat image(4, 5, CV_8UC1, cv::Scalar(0));
  EXPECT_THROW(Spread(image, NoLabels({4, 5})), std::invalid_argument);
  EXPECT_THROW(Spread(image, cv::Mat(4, 5, CV_32SC1, cv::Scalar(-1))), std::invalid_argument);
  EXPECT_THROW(Spread(cv::Mat(4, 5, CV_16UC1, cv::Scalar(0)), NoLabels({5, 4})),
               std::invalid_argument);
}

}  // namespace
}  // namespace stereo_sgmp
