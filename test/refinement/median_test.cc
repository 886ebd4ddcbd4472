#include "refinement/median.h"

#include <algorithm>
#include <vector>

#include <gtest/gtest.h>

namespace stereo_sgmp {
namespace {

// Sorts the 25 values around each pixel, with the border replicated.
cv::Mat ReferenceMedian(const cv::Mat& image) {
  cv::Mat filtered(image.size(), CV_32F);
  for (int y = 0; y < image.rows; ++y) {
    for (int x = 0; x < image.cols; ++x) {
      std::vector<float> values;
      for (int v = y - 2; v <= y + 2; ++v) {
        for (int u = x - 2; u <= x + 2; ++u) {
          values.push_back(
              image.at<float>(std::clamp(v, 0, image.rows - 1), std::clamp(u, 0, image.cols - 1)));
        }
      }
      std::nth_element(values.begin(), values.begin() + 12, values.end());
      filtered.at<float>(y, x) = values[12];
    }
  }
  return filtered;
}

TEST(MedianTest, EqualsTheDefinitionForAnySizeAndNumberOfThreads) {
  cv::theRNG().state = 3;
  for (const cv::Size size :
       {cv::Size(1, 1), {1, 2}, {2, 1}, {1, 9}, {9, 1}, {3, 3}, {31, 17}, {70, 5}}) {
    cv::Mat image(size, CV_32F);
    cv::randu(image, -10, 100);
    const cv::Mat expected = ReferenceMedian(image);
    for (const int threads : {1, 2, 3, 7}) {
      ThreadPool pool(threads);
      MedianFilter filter;
      cv::Mat filtered;
      filter.Apply(image, &filtered, &pool);
      EXPECT_EQ(cv::norm(filtered, expected, cv::NORM_INF), 0.0) << size << " " << threads;
    }
  }
}

TEST(MedianTest, IsReusedForAnotherSize) {
  ThreadPool pool(2);
  MedianFilter filter;
  cv::Mat filtered;
  for (const cv::Size size : {cv::Size(20, 30), {33, 7}, {20, 30}}) {
    cv::Mat image(size, CV_32F);
    cv::randu(image, 0, 1);
    filter.Apply(image, &filtered, &pool);
    EXPECT_EQ(cv::norm(filtered, ReferenceMedian(image), cv::NORM_INF), 0.0);
  }
}

}  // namespace
}  // namespace stereo_sgmp
