#include <cstdint>
#include <limits>

#include <gtest/gtest.h>

#include "io/color_map.h"
#include "io/prior_picture.h"

namespace stereo_sgmp {
namespace {

const cv::Vec3b kGray(48, 48, 48);

TEST(ColorDisparity, GoesFromBlueToRedAndShowsInvalidInGray) {
  const float inf = std::numeric_limits<float>::infinity();
  const float nan = std::numeric_limits<float>::quiet_NaN();
  const cv::Mat disparity = (cv::Mat_<float>(1, 7) << 10, 30, 20, 0, 40, inf, nan);
  const cv::Mat_<cv::Vec3b> picture = ColorDisparity(disparity, 10, 30);
  EXPECT_GT(picture(0, 0)[0], picture(0, 0)[2]) << "the smallest is blue";
  EXPECT_GT(picture(0, 1)[2], picture(0, 1)[0]) << "the largest is red";
  EXPECT_GT(picture(0, 2)[1], 200) << "the middle is green";
  EXPECT_EQ(picture(0, 3), picture(0, 0));
  EXPECT_EQ(picture(0, 4), picture(0, 1));
  EXPECT_EQ(picture(0, 5), kGray);
  EXPECT_EQ(picture(0, 6), kGray);
}

TEST(ColorConfidence, GoesFromDarkToBright) {
  const cv::Mat_<cv::Vec3b> picture = ColorConfidence((cv::Mat_<float>(1, 2) << 0, 1));
  EXPECT_LT(cv::sum(cv::Scalar(picture(0, 0)))[0] + 100, cv::sum(cv::Scalar(picture(0, 1)))[0]);
}

TEST(PriorPicture, ShowsPlanesByHueAndStepsAsLines) {
  PlanePriors priors;
  priors.planes = {{{0.25, 0.0, 10.0}, 1, 0.0}, {{-0.25, 0.0, 50.0}, 1, 0.0}};
  priors.labels = (cv::Mat_<std::int16_t>(1, 3) << 0, 1, -1);
  const cv::Mat_<cv::Vec3b> picture = PriorPicture(priors, {48, 4});
  int bright = 0;
  int dark = 0;
  for (int x = 0; x < 16; ++x) {
    if (picture(0, x) != picture(0, 0)) ++bright;
    if (picture(0, 16 + x) != picture(0, 16)) ++dark;
    EXPECT_EQ(picture(0, 32 + x), kGray);
  }
  EXPECT_EQ(bright, 4) << "a slant of 1/4 steps every fourth pixel";
  EXPECT_EQ(dark, 4);
  EXPECT_NE(picture(0, 0), picture(0, 16));
}

TEST(PriorPicture, IsGrayWithoutPriors) {
  const cv::Mat_<cv::Vec3b> picture = PriorPicture({}, {5, 4});
  EXPECT_EQ(picture.size(), cv::Size(5, 4));
  EXPECT_EQ(picture(3, 4), kGray);
}

}  // namespace
}  // namespace stereo_sgmp
