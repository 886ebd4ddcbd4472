#include "alignment/warp_rows.h"

#include <algorithm>
#include <cmath>
#include <cstdint>

#include <gtest/gtest.h>
#include <hwy/targets.h>

namespace stereo_sgmp {
namespace {

cv::Mat RandomImage(int width, int height, int type) {
  cv::Mat image(height, width, type);
  cv::RNG rng(7);
  rng.fill(image, cv::RNG::UNIFORM, -100, 356);  // saturates: the blend overshoots
  return image;
}

double Cubic(double t) {
  t = std::abs(t);
  if (t >= 2.0) return 0.0;
  return t < 1.0 ? (1.5 * t - 2.5) * t * t + 1.0 : ((-0.5 * t + 2.5) * t - 4.0) * t + 2.0;
}

// Byte `i` of row y, by the definition and in whole numbers.
int Reference(const cv::Mat& image, double y, int i) {
  const int row = static_cast<int>(std::floor(y));
  int weights[4];
  int rest = 128;
  for (int tap = 0; tap < 4; ++tap) {
    weights[tap] = static_cast<int>(std::lround(128.0 * Cubic(y - (row + tap - 1))));
    rest -= weights[tap];
  }
  weights[y - row < 0.5 ? 1 : 2] += rest;
  int sum = 64;
  for (int tap = 0; tap < 4; ++tap) {
    const int source = std::clamp(row + tap - 1, 0, image.rows - 1);
    sum += weights[tap] * image.ptr<std::uint8_t>(source)[i];
  }
  return std::clamp(sum >> 7, 0, 255);
}

void ExpectEqualsReference(const cv::Mat& image, double scale, double offset, ThreadPool* pool) {
  cv::Mat warped;
  WarpRows(image, scale, offset, &warped, pool);
  ASSERT_EQ(warped.size(), image.size());
  ASSERT_EQ(warped.type(), image.type());
  const int bytes = image.cols * image.channels();
  for (int y = 0; y < image.rows; ++y) {
    for (int i = 0; i < bytes; ++i) {
      ASSERT_EQ(warped.ptr<std::uint8_t>(y)[i], Reference(image, scale * y + offset, i))
          << image.size() << ", row " << y << ", byte " << i;
    }
  }
}

TEST(WarpRowsTest, EqualsReferenceOnAllTargets) {
  ThreadPool pool(2);
  const std::int64_t all = hwy::SupportedTargets();
  for (std::int64_t rest = all; rest != 0; rest &= rest - 1) {
    SCOPED_TRACE(hwy::TargetName(rest & -rest));
    hwy::SetSupportedTargetsForTest(rest & -rest);
    hwy::GetChosenTarget().Update(hwy::SupportedTargets());
    for (const cv::Size size :
         {cv::Size(1, 1), cv::Size(7, 2), cv::Size(33, 40), cv::Size(131, 25)}) {
      for (const int type : {CV_8UC1, CV_8UC3}) {
        const cv::Mat image = RandomImage(size.width, size.height, type);
        ExpectEqualsReference(image, 1.013, -0.77, &pool);
        ExpectEqualsReference(image, 0.98, 3.4, &pool);
      }
    }
  }
  hwy::SetSupportedTargetsForTest(0);
  hwy::GetChosenTarget().Update(hwy::SupportedTargets());
}

TEST(WarpRowsTest, IdentityAndWholeShiftsCopy) {
  ThreadPool pool(1);
  const cv::Mat image = RandomImage(50, 20, CV_8UC1);
  cv::Mat warped;
  WarpRows(image, 1.0, 0.0, &warped, &pool);
  EXPECT_EQ(cv::norm(warped, image, cv::NORM_INF), 0.0);
  WarpRows(image, 1.0, 3.0, &warped, &pool);
  EXPECT_EQ(cv::norm(warped.rowRange(0, 17), image.rowRange(3, 20), cv::NORM_INF), 0.0);
  EXPECT_EQ(cv::norm(warped.row(19), image.row(19), cv::NORM_INF), 0.0);
}

TEST(WarpRowsTest, FarShiftsRepeatTheBorder) {
  ThreadPool pool(1);
  const cv::Mat image = RandomImage(9, 6, CV_8UC1);
  cv::Mat warped;
  WarpRows(image, 1.0, 1e12, &warped, &pool);
  for (int y = 0; y < 6; ++y) {
    EXPECT_EQ(cv::norm(warped.row(y), image.row(5), cv::NORM_INF), 0.0);
  }
}

TEST(WarpRowsTest, FollowsASmoothRamp) {
  ThreadPool pool(1);
  cv::Mat ramp(60, 3, CV_8UC1);
  for (int y = 0; y < ramp.rows; ++y) ramp.row(y).setTo(4 * y);
  cv::Mat warped;
  WarpRows(ramp, 1.01, 0.4, &warped, &pool);
  for (int y = 2; y < 55; ++y) {
    EXPECT_NEAR(warped.at<std::uint8_t>(y, 1), 4.0 * (1.01 * y + 0.4), 1.0);
  }
}

}  // namespace
}  // namespace stereo_sgmp
