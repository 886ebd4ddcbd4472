#include "ros/camera_model.h"

#include <functional>
#include <limits>
#include <stdexcept>
#include <string>
#include <utility>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace stereo_sgmp {
namespace {

using sensor_msgs::CameraInfo;
using testing::HasSubstr;

CameraInfo Info(double cx, double p3) {
  CameraInfo info;
  info.header.frame_id = "left_optical";
  info.width = 640;
  info.height = 480;
  info.P = {500, 0, cx, p3, 0, 500, 240, 0, 0, 0, 1, 0};
  return info;
}

const cv::Size kSize(640, 480);

TEST(CameraFromInfo, ReadsTheProjectionMatrices) {
  const StereoCamera camera = CameraFromInfo(Info(320, 0), Info(330, -60), kSize);
  EXPECT_DOUBLE_EQ(camera.focal_length, 500);
  EXPECT_DOUBLE_EQ(camera.baseline, 0.12);
  EXPECT_DOUBLE_EQ(camera.cx, 320);
  EXPECT_DOUBLE_EQ(camera.cy, 240);
  EXPECT_DOUBLE_EQ(camera.doffs, 10);
}

TEST(CameraFromInfo, TakesBinningAndRegionIntoAccount) {
  CameraInfo left = Info(320, 0);
  CameraInfo right = Info(330, -60);
  for (CameraInfo* info : {&left, &right}) {
    info->binning_x = info->binning_y = 2;
    info->roi.x_offset = 20;
    info->roi.y_offset = 40;
    info->roi.width = 600;
    info->roi.height = 400;
  }
  const StereoCamera camera = CameraFromInfo(left, right, cv::Size(300, 200));
  EXPECT_DOUBLE_EQ(camera.focal_length, 250);
  EXPECT_DOUBLE_EQ(camera.baseline, 0.12);
  EXPECT_DOUBLE_EQ(camera.cx, 150);
  EXPECT_DOUBLE_EQ(camera.cy, 100);
  EXPECT_DOUBLE_EQ(camera.doffs, 5);
}

struct BadInfo {
  std::string name;
  std::function<void(CameraInfo* left, CameraInfo* right)> spoil;
  std::string sentence;  // part of it
};

class BadCameraInfo : public testing::TestWithParam<BadInfo> {};

TEST_P(BadCameraInfo, IsRefusedWithValueAndExpectation) {
  CameraInfo left = Info(320, 0);
  CameraInfo right = Info(330, -60);
  GetParam().spoil(&left, &right);
  try {
    CameraFromInfo(left, right, kSize);
    FAIL() << "accepted";
  } catch (const std::invalid_argument& error) {
    EXPECT_THAT(error.what(), HasSubstr(GetParam().sentence));
  }
}

INSTANTIATE_TEST_SUITE_P(
    All, BadCameraInfo,
    testing::Values(
        BadInfo{"overflow",
                [](CameraInfo* left, CameraInfo* right) {
                  for (CameraInfo* side : {left, right}) side->P[0] = side->P[5] = 5e-324;
                },
                "baseline of the stereo camera is inf, but it has to be positive and finite"},
        BadInfo{"zero", [](CameraInfo*, CameraInfo* right) { right->P.fill(0.0); },
                "right P[0] is 0; expected the focal length"},
        BadInfo{"baseline", [](CameraInfo*, CameraInfo* right) { right->P[3] = 0.0; },
                "right P[3] is 0; expected -fx*B"},
        BadInfo{"sign", [](CameraInfo*, CameraInfo* right) { right->P[3] = 60.0; },
                "right P[3] is 60; expected -fx*B"},
        BadInfo{"swapped", [](CameraInfo* left, CameraInfo* right) { std::swap(*left, *right); },
                "swapped"},
        BadInfo{"origin", [](CameraInfo* left, CameraInfo*) { left->P[3] = -30.0; },
                "left P[3] is -30; expected 0"},
        BadInfo{"nan",
                [](CameraInfo* left, CameraInfo*) {
                  left->P[2] = std::numeric_limits<double>::quiet_NaN();
                },
                "left P[2] is nan; expected a finite number"},
        BadInfo{"size", [](CameraInfo*, CameraInfo* right) { right->width = 320; },
                "right camera_info is of 320 x 480 pixels, the image of 640 x 480"},
        BadInfo{"focal", [](CameraInfo* left, CameraInfo*) { left->P[0] = left->P[5] = 510; },
                "expected one focal length"},
        BadInfo{"aspect",
                [](CameraInfo* left, CameraInfo* right) { left->P[5] = right->P[5] = 400; },
                "expected square pixels"},
        BadInfo{"rows", [](CameraInfo* left, CameraInfo*) { left->P[6] = 250; },
                "expected the same row"}),
    [](const auto& bad) { return bad.param.name; });

TEST(FrameIdProblem, NamesBothFrames) {
  CameraInfo left = Info(320, 0);
  CameraInfo right = Info(330, -60);
  EXPECT_EQ(FrameIdProblem(left, right), "");
  right.header.frame_id = "right_optical";
  EXPECT_THAT(FrameIdProblem(left, right),
              testing::AllOf(HasSubstr("'left_optical'"), HasSubstr("'right_optical'")));
}

}  // namespace
}  // namespace stereo_sgmp
