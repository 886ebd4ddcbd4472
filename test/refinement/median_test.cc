#include "refinement/median.h"

#include <gtest/gtest.h>
#include <hwy/targets.h>

#include <algorithm>
#include <random>
#include <vector>

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

cv::Mat Median(const cv::Mat& image) {
  AlignedBuffer<float> scratch;
  cv::Mat filtered(image.size(), CV_32F);
  const int middle = image.rows / 2;
  MedianOfRows(image, middle, image.rows, &scratch, &filtered);
  MedianOfRows(image, 0, middle, &scratch, &filtered);
  return filtered;
}

TEST(MedianTest, EqualsTheDefinitionForAnySizeOnEveryTarget) {
  cv::theRNG().state = 3;
  for (const cv::Size size :
       {cv::Size(1, 1), {1, 2}, {2, 1}, {1, 9}, {9, 1}, {3, 3}, {31, 17}, {16, 4}, {70, 5}}) {
    for (const int values : {2, 5, 100000}) {  // with many equal ones, with few
      cv::Mat whole(size, CV_32S);
      cv::randu(whole, -values, values);
      cv::Mat image;
      whole.convertTo(image, CV_32F, 0.37);
      const cv::Mat expected = ReferenceMedian(image);
      for (const auto target : hwy::SupportedAndGeneratedTargets()) {
        hwy::SetSupportedTargetsForTest(target);
        EXPECT_EQ(cv::norm(Median(image), expected, cv::NORM_INF), 0.0)
            << size << " " << hwy::TargetName(target);
      }
      hwy::SetSupportedTargetsForTest(0);
    }
  }
}

// What holds for all arrangements of two values holds for all values, as the median is found by
// minima and maxima alone.
TEST(MedianTest, TellsAnyNumberOfLargeValuesFromSmallOnes) {
  std::mt19937 random(7);
  for (int i = 0; i < 300; ++i) {
    cv::Mat image(9, 40, CV_32F);
    const auto share = random() % 100;
    for (int y = 0; y < image.rows; ++y) {
      for (int x = 0; x < image.cols; ++x) {
        image.at<float>(y, x) = random() % 100 < share ? 1.0F : 0.0F;
      }
    }
    ASSERT_EQ(cv::norm(Median(image), ReferenceMedian(image), cv::NORM_INF), 0.0) << share;
  }
}

}  // namespace
}  // namespace stereo_sgmp
