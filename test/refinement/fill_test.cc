#include "refinement/fill.h"

#include <algorithm>

#include <gtest/gtest.h>

namespace stereo_sgmp {
namespace {

constexpr float kHole = -99.0f;

// Holes are the pixels that hold kHole.
cv::Mat Filled(const cv::Mat& disparity, int threads = 1) {
  ThreadPool pool(threads);
  cv::Mat filled = disparity.clone();
  FillScanlines(disparity != kHole, 3.0f, &filled, &pool);
  return filled;
}

void ExpectEqual(const cv::Mat& actual, const cv::Mat& expected) {
  EXPECT_EQ(cv::norm(actual, expected, cv::NORM_INF), 0.0) << actual << expected;
}

TEST(FillTest, HolesTakeTheSmallerNeighbour) {
  const float h = kHole;
  const cv::Mat disparity = (cv::Mat_<float>(2, 7) << 9, h, h, 5, h, 7, 8,  //
                             -4, h, -2, h, h, h, -6);
  const cv::Mat expected = (cv::Mat_<float>(2, 7) << 9, 5, 5, 5, 5, 7, 8,  //
                            -4, -4, -2, -6, -6, -6, -6);
  ExpectEqual(Filled(disparity), expected);
}

TEST(FillTest, HolesAtTheEndsTakeTheOnlyNeighbour) {
  const float h = kHole;
  const cv::Mat disparity = (cv::Mat_<float>(1, 6) << h, h, 5, 7, h, h);
  const cv::Mat expected = (cv::Mat_<float>(1, 6) << 5, 5, 5, 7, 7, 7);
  ExpectEqual(Filled(disparity), expected);
}

TEST(FillTest, EmptyRowsCopyTheNearestRow) {
  const float h = kHole;
  const cv::Mat disparity =
      (cv::Mat_<float>(8, 2) << h, h, 1, h, h, h, h, h, h, h, h, 8, 9, 9, h, h);
  const cv::Mat expected =
      (cv::Mat_<float>(8, 2) << 1, 1, 1, 1, 1, 1, 1, 1, 8, 8, 8, 8, 9, 9, 9, 9);
  ExpectEqual(Filled(disparity), expected);
}

TEST(FillTest, NothingValidGivesTheFallback) {
  for (const cv::Size size : {cv::Size(1, 1), {1, 5}, {5, 1}, {4, 3}}) {
    ExpectEqual(Filled(cv::Mat(size, CV_32F, cv::Scalar(kHole))),
                cv::Mat(size, CV_32F, cv::Scalar(3)));
  }
}

TEST(FillTest, ValidPixelsStayAndThreadsDoNotMatter) {
  cv::Mat disparity(41, 53, CV_32F);
  cv::theRNG().state = 5;
  cv::randu(disparity, 0, 64);
  disparity.setTo(kHole, disparity < 30);
  disparity.rowRange(7, 12).setTo(kHole);
  const cv::Mat filled = Filled(disparity);
  cv::Mat kept;
  filled.copyTo(kept, disparity != kHole);
  disparity.setTo(0, disparity == kHole);
  ExpectEqual(kept, disparity);
  EXPECT_GE(*std::min_element(filled.begin<float>(), filled.end<float>()), 30.0f);
  disparity.setTo(kHole, disparity == 0);
  ExpectEqual(Filled(disparity, 3), filled);
}

}  // namespace
}  // namespace stereo_sgmp
