#include "geometry/normals_from_disparity.h"

#include <cmath>
#include <limits>
#include <stdexcept>

#include <gtest/gtest.h>

namespace stereo_sgmp {
namespace {

constexpr float kInfinity = std::numeric_limits<float>::infinity();

StereoCamera OddCamera() {
  StereoCamera camera;
  camera.focal_length = 40.0;
  camera.cx = 55.3;  // outside the image
  camera.cy = 7.9;
  camera.doffs = 31.086;
  camera.baseline = 0.193;
  return camera;
}

cv::Mat MapOf(cv::Size size, const DisparityPlane& plane) {
  cv::Mat map(size, CV_32F);
  map.forEach<float>([&](float& d, const int* p) { d = static_cast<float>(plane.At(p[1], p[0])); });
  return map;
}

double Distance(const cv::Vec3f& normal, const StereoCamera& camera, const DisparityPlane& plane) {
  const Eigen::Vector3d n = camera.ToSpace(plane).normal;
  return cv::norm(cv::Vec3d(normal), cv::Vec3d(n.x(), n.y(), n.z()), cv::NORM_INF);
}

TEST(NormalsFromDisparity, AreExactOnPlanesUpToTheBorder) {
  cv::RNG rng(3);
  for (int i = 0; i < 40; ++i) {
    StereoCamera camera = OddCamera();
    camera.doffs = rng.uniform(-8.0, 40.0);
    const DisparityPlane plane = {rng.uniform(-0.5, 0.5), rng.uniform(-0.45, 0.45), 27.0};
    const cv::Mat normals = NormalsFromDisparity(MapOf({24, 13}, plane), camera);
    ASSERT_EQ(normals.type(), CV_32FC3);
    for (int y = 0; y < normals.rows; ++y) {
      for (int x = 0; x < normals.cols; ++x) {
        ASSERT_LT(Distance(normals.at<cv::Vec3f>(y, x), camera, plane), 1e-5) << x << ' ' << y;
      }
    }
  }
}

TEST(NormalsFromDisparity, OfAFrontoParallelWallFaceTheCamera) {
  const cv::Mat normals = NormalsFromDisparity(MapOf({9, 9}, {0, 0, 20}), OddCamera());
  EXPECT_EQ(normals.at<cv::Vec3f>(4, 4), cv::Vec3f(0, 0, -1));
}

TEST(NormalsFromDisparity, DoNotMixTheSurfacesOnBothSidesOfAnEdge) {
  const StereoCamera camera = OddCamera();
  const DisparityPlane near = {0.1, -0.2, 30.0};
  const DisparityPlane far = {-0.05, 0.1, 10.0};
  cv::Mat map = MapOf({30, 20}, near);
  MapOf({30, 20}, far).colRange(15, 30).copyTo(map.colRange(15, 30));
  const cv::Mat normals = NormalsFromDisparity(map, camera);
  for (int y = 0; y < map.rows; ++y) {
    for (int x = 0; x < map.cols; ++x) {
      ASSERT_LT(Distance(normals.at<cv::Vec3f>(y, x), camera, x < 15 ? near : far), 1e-5)
          << x << ' ' << y;
    }
  }
}

// Where surfaces meet there is no step to tell them apart by.
TEST(NormalsFromDisparity, StaySharpAtCreases) {
  const StereoCamera camera = OddCamera();
  const DisparityPlane left = {0.4, 0.0, 10.0};
  const DisparityPlane right = {-0.4, 0.0, 22.0};  // meets the left one at x = 15
  cv::Mat map = MapOf({31, 20}, left);
  MapOf({31, 20}, right).colRange(15, 31).copyTo(map.colRange(15, 31));
  const cv::Mat normals = NormalsFromDisparity(map, camera);
  for (int x = 0; x < map.cols; ++x) {
    const cv::Vec3f& normal = normals.at<cv::Vec3f>(10, x);
    const bool is_left = Distance(normal, camera, left) < 1e-5;
    const bool is_right = Distance(normal, camera, right) < 1e-5;
    EXPECT_TRUE(x < 15 ? is_left : x > 15 ? is_right : is_left || is_right) << x;
  }
}

TEST(NormalsFromDisparity, KeepThinSurfaces) {
  const StereoCamera camera = OddCamera();
  cv::Mat map = MapOf({30, 20}, {0.1, 0.1, 5.0});
  map.colRange(14, 16).setTo(30.0f);
  const cv::Mat normals = NormalsFromDisparity(map, camera);
  EXPECT_LT(Distance(normals.at<cv::Vec3f>(10, 14), camera, {0, 0, 30}), 1e-5);
  EXPECT_LT(Distance(normals.at<cv::Vec3f>(10, 13), camera, {0.1, 0.1, 5}), 1e-5);
}

TEST(NormalsFromDisparity, AverageNoise) {
  StereoCamera camera = OddCamera();
  cv::Mat map = MapOf({60, 60}, {0.1, 0.1, 20.0});
  cv::Mat noise(map.size(), CV_32F);
  cv::RNG(5).fill(noise, cv::RNG::NORMAL, 0.0, 0.08);
  const cv::Mat_<cv::Vec3f> normals = NormalsFromDisparity(map + noise, camera);
  double worst = 0.0;
  for (const cv::Vec3f& n : normals) {
    worst = std::max(worst, Distance(n, camera, {0.1, 0.1, 20.0}));
  }
  EXPECT_LT(worst, 0.06);  // neighbours alone would be wrong by up to 0.3
}

TEST(NormalsFromDisparity, AreZeroWhereNothingIsKnown) {
  cv::Mat map = MapOf({20, 20}, {0, 0, 12});
  map.at<float>(5, 5) = kInfinity;
  map.at<float>(6, 5) = std::numeric_limits<float>::quiet_NaN();
  map.at<float>(7, 5) = -40.0f;  // behind the camera: d + doffs < 0
  cv::Mat lonely(20, 20, CV_32F, kInfinity);
  lonely.at<float>(3, 3) = 12.0f;
  lonely.row(10).setTo(12.0f);  // a line is no plane
  const cv::Mat normals = NormalsFromDisparity(map, OddCamera());
  for (const int y : {5, 6, 7}) EXPECT_EQ(normals.at<cv::Vec3f>(y, 5), cv::Vec3f::all(0));
  EXPECT_EQ(normals.at<cv::Vec3f>(8, 5), cv::Vec3f(0, 0, -1));
  EXPECT_EQ(cv::norm(NormalsFromDisparity(lonely, OddCamera())), 0.0);
}

TEST(NormalsFromDisparity, NeedDisparitiesAndACamera) {
  EXPECT_THROW(NormalsFromDisparity(cv::Mat(3, 3, CV_8U), OddCamera()), std::invalid_argument);
  EXPECT_THROW(NormalsFromDisparity(cv::Mat(3, 3, CV_32F), StereoCamera()), std::invalid_argument);
}

}  // namespace
}  // namespace stereo_sgmp
