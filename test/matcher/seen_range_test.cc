#include "matcher/seen_range.h"

#include <gtest/gtest.h>

namespace stereo_sgmp {
namespace {

constexpr int kFactor = 2;
const cv::Size kCoarse(200, 150);  // surfaces have at least 30 pixels

// A wall at 20 coarse pixels.
cv::Mat Wall() { return cv::Mat(kCoarse, CV_32F, cv::Scalar(20.0)); }

VolumeShape FullShape(int disparities, int min_disparity = 0) {
  return {kFactor * kCoarse.width, kFactor * kCoarse.height, disparities, min_disparity};
}

class SeenRangeTest : public ::testing::Test {
 protected:
  int Find(const cv::Mat& coarse, const VolumeShape& full) {
    const VolumeShape found = range_.Find(coarse, full, &pool_);
    EXPECT_EQ(found.min_disparity, full.min_disparity);
    EXPECT_EQ(found.width, full.width);
    EXPECT_EQ(found.height, full.height);
    return found.disparities;
  }

  ThreadPool pool_{2};
  SeenRange range_;
};

TEST_F(SeenRangeTest, LeavesOutWholeBlocksBeyondTheNearestSurface) {
  EXPECT_EQ(Find(Wall(), FullShape(256)), 64);
  EXPECT_EQ(Find(Wall(), FullShape(100)), 64);
  EXPECT_EQ(Find(Wall(), FullShape(64)), 64);
  EXPECT_EQ(Find(Wall(), FullShape(40)), 40);
}

TEST_F(SeenRangeTest, KeepsASmallSurfaceThatComesNear) {
  cv::Mat coarse = Wall();
  coarse(cv::Rect(50, 20, 2, 15)).setTo(70.0);  // a pole
  EXPECT_EQ(Find(coarse, FullShape(256)), 192);
  EXPECT_EQ(Find(coarse, FullShape(150)), 150);
  coarse(cv::Rect(50, 20, 2, 1)).setTo(20.0);  // too short now
  EXPECT_EQ(Find(coarse, FullShape(256)), 64);
}

TEST_F(SeenRangeTest, KeepsTheRangeWhereLittleIsCertain) {
  cv::Mat coarse = Wall();
  for (int y = 0; y < coarse.rows; y += 2) {
    for (int x = 0; x < coarse.cols; ++x) coarse.at<float>(y, x) = x % 2 == 0 ? 10.0F : 30.0F;
  }
  EXPECT_EQ(Find(coarse, FullShape(256)), 64);  // the rows between are surfaces
  coarse.row(1).copyTo(coarse.row(2));
  coarse.row(0).copyTo(coarse.row(1));
  coarse.row(0).copyTo(coarse.row(3));
  EXPECT_EQ(Find(coarse, FullShape(256)), 256);
}

TEST_F(SeenRangeTest, LeavesAMarginOfOneCoarsePixel) {
  EXPECT_EQ(Find(cv::Mat(kCoarse, CV_32F, cv::Scalar(30.5)), FullShape(256)), 64);
  EXPECT_EQ(Find(cv::Mat(kCoarse, CV_32F, cv::Scalar(31.0)), FullShape(256)), 128);
}

TEST_F(SeenRangeTest, FollowsASlope) {
  cv::Mat coarse = Wall();
  for (int y = 0; y < coarse.rows; ++y) coarse.row(y).setTo(0.5 * y);  // up to 74.5
  EXPECT_EQ(Find(coarse, FullShape(256)), 192);
}

TEST_F(SeenRangeTest, CountsFromTheSmallestDisparity) {
  EXPECT_EQ(Find(Wall(), FullShape(256, -30)), 128);
  EXPECT_EQ(Find(Wall(), FullShape(256, 30)), 64);
  EXPECT_EQ(Find(cv::Mat(kCoarse, CV_32F, cv::Scalar(-20.0)), FullShape(256, -50)), 64);
}

}  // namespace
}  // namespace stereo_sgmp
