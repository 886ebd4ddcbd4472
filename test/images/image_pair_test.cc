#include "images/image_pair.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <opencv2/imgproc.hpp>
#include <stdexcept>
#include <string>

namespace stereo_sgmp {
namespace {

using ::testing::HasSubstr;

cv::Mat RandomImage(int rows, int cols, int type, int limit) {
  cv::Mat image(rows, cols, type);
  cv::RNG random(static_cast<std::uint64_t>(rows * 1000 + cols));
  random.fill(image, cv::RNG::UNIFORM, 0, limit);
  return image;
}

std::string ErrorOf(const cv::Mat& left, const cv::Mat& right) {
  ImagePair pair;
  try {
    pair.Prepare(left, right);
  } catch (const std::invalid_argument& error) {
    return error.what();
  }
  return "no error";
}

bool Same(const cv::Mat& a, const cv::Mat& b) {
  return a.size() == b.size() && a.type() == b.type() && cv::norm(a, b, cv::NORM_INF) == 0.0;
}

TEST(ImagePairTest, GrayImagesAreCopiedNotShared) {
  const cv::Mat image = RandomImage(5, 7, CV_8UC1, 256);
  ImagePair pair;
  pair.Prepare(image, image);
  EXPECT_TRUE(Same(pair.left_gray(), image));
  EXPECT_TRUE(Same(pair.left_color(), image));
  // The right image is warped in place; the caller's must stay.
  EXPECT_NE(pair.right_gray().data, image.data);
}

TEST(ImagePairTest, SixteenBitsLoseTheBitsAboveEightOfTheBrighterImage) {
  const cv::Mat narrow = RandomImage(6, 6, CV_16UC1, 1024);  // ten bits
  const cv::Mat dark = narrow / 2;
  ImagePair pair;
  pair.Prepare(dark, narrow);
  cv::Mat expected;
  narrow.convertTo(expected, CV_8U, 0.25);
  EXPECT_TRUE(Same(pair.right_gray(), expected));
}

TEST(ImagePairTest, AlphaIsDroppedAndColourKept) {
  const cv::Mat bgr = RandomImage(6, 9, CV_8UC3, 256);
  cv::Mat bgra;
  cv::cvtColor(bgr, bgra, cv::COLOR_BGR2BGRA);
  ImagePair pair;
  pair.Prepare(bgra, bgra);
  EXPECT_TRUE(Same(pair.left_color(), bgr));
  cv::Mat gray;
  cv::cvtColor(bgr, gray, cv::COLOR_BGR2GRAY);
  EXPECT_TRUE(Same(pair.left_gray(), gray));
}

TEST(ImagePairTest, TypesMayChangeFromFrameToFrame) {
  ThreadPool pool(2);
  ImagePair full;
  ImagePair coarse;
  for (const int type : {CV_8UC3, CV_8UC1, CV_16UC1, CV_8UC4, CV_16UC3, CV_8UC1}) {
    const cv::Mat image = RandomImage(8, 12, type, 256);
    full.Prepare(image, image);
    coarse.Shrink(full, {3, 2}, &pool);
    EXPECT_EQ(full.left_gray().type(), CV_8UC1);
    EXPECT_EQ(full.left_color().channels(), image.channels() == 1 ? 1 : 3);
    EXPECT_EQ(coarse.left_color().size(), cv::Size(3, 2));
    EXPECT_EQ(coarse.left_color().type(), full.left_color().type());
  }
}

TEST(ImagePairTest, WhatCanNotBeMatchedIsNamed) {
  const cv::Mat gray = RandomImage(4, 4, CV_8UC1, 256);
  EXPECT_THAT(ErrorOf(cv::Mat(), gray), HasSubstr("left image is empty"));
  EXPECT_THAT(ErrorOf(gray, cv::Mat()), HasSubstr("right image is empty"));
  EXPECT_THAT(ErrorOf(gray, RandomImage(4, 5, CV_8UC1, 256)), HasSubstr("4x4"));
  EXPECT_THAT(ErrorOf(gray, RandomImage(4, 4, CV_8UC3, 256)), HasSubstr("expected one type"));
  const cv::Mat real(4, 4, CV_32F, cv::Scalar(0));
  EXPECT_THAT(ErrorOf(real, real), HasSubstr("8 or 16 bit"));
  const cv::Mat two(4, 4, CV_8UC2, cv::Scalar(0));
  EXPECT_THAT(ErrorOf(two, two), HasSubstr("2 channels"));
}

}  // namespace
}  // namespace stereo_sgmp
