#include "prior/superpixels.h"

#include <cstdint>
#include <set>
#include <stdexcept>

#include <gtest/gtest.h>
#include <opencv2/imgproc.hpp>

namespace stereo_sgmp {
namespace {

constexpr double kCompactness = 20.0;

cv::Mat Picture(int width, int height, int type) {
  cv::Mat picture(height, width, type);
  cv::theRNG().state = 5;
  cv::randu(picture, cv::Scalar::all(0), cv::Scalar::all(256));
  cv::GaussianBlur(picture, picture, {9, 9}, 3.0);
  return picture;
}

// Components of equal labels, counted by OpenCV label by label.
void ExpectConnected(const Superpixels& superpixels) {
  for (int label = 0; label < superpixels.count(); ++label) {
    const cv::Mat mask = superpixels.labels() == label;
    cv::Mat components;
    EXPECT_EQ(cv::connectedComponents(mask, components, 4), 2) << "label " << label;
  }
}

TEST(Superpixels, AreConnectedAndOfPlausibleNumber) {
  Superpixels superpixels;
  for (const int type : {CV_8UC1, CV_8UC3, CV_8UC4}) {
    const cv::Mat image = Picture(173, 118, type);
    superpixels.Segment(image, 12, kCompactness, nullptr);
    ASSERT_EQ(superpixels.labels().size(), image.size());
    double least = 0.0;
    double most = 0.0;
    cv::minMaxLoc(superpixels.labels(), &least, &most);
    EXPECT_EQ(least, 0.0);
    EXPECT_EQ(most, superpixels.count() - 1);
    EXPECT_GT(superpixels.count(), 173 * 118 / 144 / 2);
    EXPECT_LT(superpixels.count(), 173 * 118 / 144 * 2);
    ExpectConnected(superpixels);
  }
}

TEST(Superpixels, FollowAColourEdge) {
  cv::Mat image(60, 80, CV_8UC3, cv::Scalar(40, 40, 200));
  image.colRange(37, 80).setTo(cv::Scalar(200, 60, 40));
  Superpixels superpixels;
  superpixels.Segment(image, 10, kCompactness, nullptr);
  std::set<int> left;
  for (int y = 0; y < 60; ++y) {
    for (int x = 0; x < 37; ++x) left.insert(superpixels.labels().at<std::int32_t>(y, x));
  }
  for (int y = 0; y < 60; ++y) {
    for (int x = 37; x < 80; ++x) {
      EXPECT_EQ(left.count(superpixels.labels().at<std::int32_t>(y, x)), 0U);
    }
  }
}

TEST(Superpixels, SameForAnyThreadsAndBufferState) {
  const cv::Mat image = Picture(157, 93, CV_8UC3);
  Superpixels expected;
  expected.Segment(image, 14, kCompactness, nullptr);
  ThreadPool threads(3);
  Superpixels threaded;
  threaded.Segment(Picture(40, 150, CV_8UC1), 9, kCompactness, &threads);
  threaded.Segment(image, 14, kCompactness, &threads);
  EXPECT_EQ(threaded.count(), expected.count());
  EXPECT_EQ(cv::norm(threaded.labels(), expected.labels(), cv::NORM_INF), 0.0);
}

TEST(Superpixels, SmallImagesAndSizes) {
  Superpixels superpixels;
  for (const cv::Size size : {cv::Size(1, 1), cv::Size(1, 40), cv::Size(40, 1), cv::Size(5, 3)}) {
    const cv::Mat image(size, CV_8UC3, cv::Scalar(9, 80, 3));
    superpixels.Segment(image, 14, kCompactness, nullptr);
    EXPECT_EQ(superpixels.labels().size(), size);
    EXPECT_GE(superpixels.count(), 1);
  }
  superpixels.Segment(cv::Mat(4, 6, CV_8UC1, cv::Scalar(0)), 1, kCompactness, nullptr);
  EXPECT_EQ(superpixels.count(), 24);
}

TEST(Superpixels, RefusesWhatItCantSegment) {
  Superpixels superpixels;
  const cv::Mat image(8, 8, CV_8UC3, cv::Scalar());
  EXPECT_THROW(superpixels.Segment(cv::Mat(8, 8, CV_16UC1), 4, kCompactness, nullptr),
               std::invalid_argument);
  EXPECT_THROW(superpixels.Segment(image, 0, kCompactness, nullptr), std::invalid_argument);
  EXPECT_THROW(superpixels.Segment(image, 4, 0.0, nullptr), std::invalid_argument);
}

}  // namespace
}  // namespace stereo_sgmp
