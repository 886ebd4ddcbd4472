#include "refinement/superpixel_planes.h"

#include <cmath>

#include <gtest/gtest.h>

namespace stereo_sgmp {
namespace {

constexpr int kWidth = 40;
constexpr int kHeight = 20;
constexpr int kDisparities = 64;

// Two superpixels, left and right, on a plane each, all valid.
class SuperpixelPlanesTest : public testing::Test {
 protected:
  SuperpixelPlanesTest() {
    for (int y = 0; y < kHeight; ++y) {
      for (int x = 0; x < kWidth; ++x) {
        labels_.at<int>(y / 2, x / 2) = x < kWidth / 2 ? 0 : 1;
        disparity_.at<float>(y, x) = PlaneAt(x, y);
      }
    }
  }

  static float PlaneAt(int x, int y) {
    return x < kWidth / 2 ? 20.0f + 0.25f * static_cast<float>(x)
                          : 10.0f - 0.125f * static_cast<float>(y);
  }

  void Apply(int threads = 1) {
    ThreadPool pool(threads);
    const VolumeShape shape = {kWidth, kHeight, kDisparities, 0};
    planes_.Apply(labels_, 2, shape, &disparity_, &valid_, &pool);
  }

  void Invalidate(int x, int y) {
    valid_.at<std::uint8_t>(y, x) = 0;
    disparity_.at<float>(y, x) = 60.0f;
  }

  SuperpixelPlanes planes_;
  cv::Mat labels_ = cv::Mat(kHeight / 2, kWidth / 2, CV_32S);
  cv::Mat disparity_ = cv::Mat(kHeight, kWidth, CV_32F);
  cv::Mat valid_ = cv::Mat(kHeight, kWidth, CV_8U, cv::Scalar(1));
};

TEST_F(SuperpixelPlanesTest, InvalidPixelsTakeThePlaneOfTheirSuperpixel) {
  for (int x = 0; x < kWidth; x += 3) {
    for (int y = 0; y < kHeight; y += 2) Invalidate(x, y);
  }
  Apply();
  EXPECT_EQ(cv::countNonZero(valid_), kWidth * kHeight);
  for (int y = 0; y < kHeight; ++y) {
    for (int x = 0; x < kWidth; ++x) {
      EXPECT_NEAR(disparity_.at<float>(y, x), PlaneAt(x, y), 1e-3) << x << " " << y;
    }
  }
}

TEST_F(SuperpixelPlanesTest, ValidPixelsKeepTheirDisparity) {
  disparity_.at<float>(5, 5) = PlaneAt(5, 5) + 0.5f;
  const cv::Mat before = disparity_.clone();
  Apply();
  EXPECT_EQ(cv::norm(disparity_, before, cv::NORM_INF), 0.0);
}

TEST_F(SuperpixelPlanesTest, OutliersDoNotBendThePlane) {
  for (int y = 0; y < kHeight; ++y) {
    for (int x = 0; x < 8; ++x) disparity_.at<float>(y, x) = 50.0f;  // 40 % of the left one
  }
  Invalidate(12, 9);
  Apply();
  EXPECT_NEAR(disparity_.at<float>(9, 12), PlaneAt(12, 9), 1e-3);
}

TEST_F(SuperpixelPlanesTest, PlaneIsTheBestFitOfManyPixels) {
  cv::Mat noise(disparity_.size(), CV_32F);
  cv::RNG(8).fill(noise, cv::RNG::UNIFORM, -0.2, 0.2);
  disparity_ += noise;
  for (int x = 0; x < kWidth; x += 2) Invalidate(x, (3 * x) % kHeight);
  Apply();
  for (int x = 0; x < kWidth; x += 2) {
    const int y = (3 * x) % kHeight;
    EXPECT_NEAR(disparity_.at<float>(y, x), PlaneAt(x, y), 0.07);
  }
}

TEST_F(SuperpixelPlanesTest, SuperpixelsWithoutAMajorityPlaneAreLeftAlone) {
  cv::RNG random(9);
  random.fill(disparity_.colRange(0, kWidth / 2), cv::RNG::UNIFORM, 0, 60);
  Invalidate(3, 3);
  Apply();
  EXPECT_EQ(valid_.at<std::uint8_t>(3, 3), 0);
  EXPECT_EQ(disparity_.at<float>(3, 3), 60.0f);
}

// Only pixels at even places count.
TEST_F(SuperpixelPlanesTest, SuperpixelsWithFewValidPixelsAreLeftAlone) {
  valid_.colRange(0, kWidth / 2).setTo(0);
  valid_(cv::Rect(0, 0, 20, 6)).setTo(1);
  valid_.at<std::uint8_t>(0, 0) = 0;
  Apply();
  EXPECT_EQ(valid_.at<std::uint8_t>(10, 5), 0);
  valid_.at<std::uint8_t>(0, 0) = 1;  // the thirtieth
  Apply();
  EXPECT_NE(valid_.at<std::uint8_t>(10, 5), 0);
}

TEST_F(SuperpixelPlanesTest, ValuesOutsideTheRangeAreNotTaken) {
  for (int y = 0; y < kHeight; ++y) {
    for (int x = 0; x < kWidth / 2; ++x) {
      disparity_.at<float>(y, x) = 4.0f * static_cast<float>(x) - 5.0f;
    }
  }
  Invalidate(0, 5);
  Invalidate(19, 5);
  Invalidate(10, 5);
  Apply();
  EXPECT_EQ(valid_.at<std::uint8_t>(5, 0), 0);
  EXPECT_EQ(valid_.at<std::uint8_t>(5, 19), 0);
  EXPECT_NEAR(disparity_.at<float>(5, 10), 35.0f, 1e-2);
}

TEST_F(SuperpixelPlanesTest, DoesNotDependOnThreadsOrOnEarlierCalls) {
  cv::RNG random(4);
  cv::Mat noise(disparity_.size(), CV_32F);
  random.fill(noise, cv::RNG::UNIFORM, -1.0, 1.0);
  disparity_ += noise;
  for (int x = 0; x < kWidth; x += 3) Invalidate(x, x / 2);
  const cv::Mat start = disparity_.clone();
  const cv::Mat start_valid = valid_.clone();
  Apply();
  const cv::Mat expected = disparity_.clone();
  start.copyTo(disparity_);
  start_valid.copyTo(valid_);
  Apply(3);
  EXPECT_EQ(cv::norm(disparity_, expected, cv::NORM_INF), 0.0);
}

TEST(SuperpixelPlanesSizeTest, TinyImages) {
  for (const cv::Size size : {cv::Size(1, 1), {1, 50}, {50, 1}}) {
    ThreadPool pool(2);
    const cv::Mat labels = cv::Mat::zeros(SuperpixelPlanes::LabelSize(size), CV_32S);
    cv::Mat disparity(size, CV_32F, cv::Scalar(7));
    cv::Mat valid(size, CV_8U, cv::Scalar(1));
    valid.at<std::uint8_t>(size.height - 1, size.width - 1) = 0;
    SuperpixelPlanes().Apply(labels, 1, {size.width, size.height, 16, 0}, &disparity, &valid,
                             &pool);
    EXPECT_EQ(cv::norm(disparity, cv::Mat(size, CV_32F, cv::Scalar(7)), cv::NORM_INF), 0.0);
  }
}

}  // namespace
}  // namespace stereo_sgmp
