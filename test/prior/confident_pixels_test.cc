#include "prior/confident_pixels.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <stdexcept>
#include <vector>

namespace stereo_sgmp {
namespace {

TEST(ConfidentPixels, KeepsTheQuantileOfLowUncertainty) {
  cv::Mat uncertainty(10, 10, CV_16UC1);
  for (int i = 0; i < 100; ++i) {
    uncertainty.at<std::uint16_t>(i / 10, i % 10) = static_cast<std::uint16_t>((i * 37) % 100);
  }
  const cv::Mat disparity(10, 10, CV_32FC1, cv::Scalar(0));
  const cv::Mat right(10, 10, CV_16UC1, cv::Scalar(0));
  ConfidentPixels pixels;
  pixels.Select(uncertainty, disparity, right, 0, 0.79, nullptr);
  EXPECT_EQ(cv::countNonZero(pixels.mask()), 80);
  EXPECT_EQ(cv::countNonZero(pixels.mask() & (uncertainty > 79)), 0);
}

TEST(ConfidentPixels, TakesTheValueOfTheRankAsTheLimit) {
  ThreadPool threads(3);
  cv::RNG random(5);
  for (const int largest : {3, 700, 0x10000}) {
    cv::Mat uncertainty(23, 31, CV_16UC1);
    random.fill(uncertainty, cv::RNG::UNIFORM, 0, largest);
    std::vector<std::uint16_t> sorted(uncertainty.begin<std::uint16_t>(),
                                      uncertainty.end<std::uint16_t>());
    std::sort(sorted.begin(), sorted.end());
    const cv::Mat disparity(uncertainty.size(), CV_32FC1, cv::Scalar(0));
    const cv::Mat right(uncertainty.size(), CV_16UC1, cv::Scalar(0));
    for (const double quantile : {0.0, 0.3, 0.95, 1.0}) {
      const double rank = quantile * static_cast<double>(sorted.size());
      const auto limit = sorted[std::min(sorted.size() - 1, static_cast<std::size_t>(rank))];
      for (ThreadPool* pool : {&threads, static_cast<ThreadPool*>(nullptr)}) {
        ConfidentPixels pixels;
        pixels.Select(uncertainty, disparity, right, 0, quantile, pool);
        EXPECT_EQ(cv::norm(pixels.mask(), uncertainty <= limit, cv::NORM_INF), 0.0)
            << largest << " " << quantile;
      }
    }
  }
}

TEST(ConfidentPixels, ComparesWithTheRightWinner) {
  const cv::Mat uncertainty(1, 6, CV_16UC1, cv::Scalar(0));
  const cv::Mat disparity = (cv::Mat_<float>(1, 6) << 1.0F, 0.4F, 1.0F, 1.0F, 1.0F, 3.0F);
  // Indices count from min_disparity = -2: a winner of 1 is index 3.
  const cv::Mat right = (cv::Mat_<std::uint16_t>(1, 6) << 3, 3, 5, 0xFFFF, 3, 3);
  ConfidentPixels pixels;
  pixels.Select(uncertainty, disparity, right, -2, 1.0, nullptr);
  // Outside; 0 against 1; 1 against 1; 1 against 3; 1 against none; 3 against 3.
  const cv::Mat expected = (cv::Mat_<std::uint8_t>(1, 6) << 0, 255, 255, 0, 0, 255);
  EXPECT_EQ(cv::norm(pixels.mask(), expected, cv::NORM_INF), 0.0) << pixels.mask();
}

TEST(ConfidentPixels, RefusesMapsThatDontFit) {
  ConfidentPixels pixels;
  const cv::Mat disparity(3, 3, CV_32FC1, cv::Scalar(0));
  const cv::Mat right(3, 3, CV_16UC1, cv::Scalar(0));
  EXPECT_THROW(pixels.Select(cv::Mat(2, 3, CV_16UC1), disparity, right, 0, 0.9, nullptr),
               std::invalid_argument);
  EXPECT_THROW(pixels.Select(cv::Mat(3, 3, CV_8UC1), disparity, right, 0, 0.9, nullptr),
               std::invalid_argument);
}

}  // namespace
}  // namespace stereo_sgmp
