#include "stereo_sgmp/stereo_camera.h"

#include <cmath>
#include <limits>
#include <stdexcept>
#include <string>
#include <vector>

#include <gtest/gtest.h>
#include <Eigen/Dense>

namespace stereo_sgmp {
namespace {

StereoCamera OddCamera() {
  StereoCamera camera;
  camera.focal_length = 994.978;
  camera.cx = 311.193;
  camera.cy = 254.877;
  camera.doffs = 31.086;
  camera.baseline = 0.193001;
  return camera;
}

std::string CheckMessage(const StereoCamera& camera) {
  try {
    camera.Check();
  } catch (const std::invalid_argument& error) {
    return error.what();
  }
  return "";
}

TEST(StereoCameraTest, DepthFollowsTheTextbookFormula) {
  StereoCamera camera;
  camera.focal_length = 500.0;
  camera.baseline = 0.1;
  EXPECT_DOUBLE_EQ(camera.DepthOf(10.0), 5.0);
  camera.doffs = 15.0;
  EXPECT_DOUBLE_EQ(camera.DepthOf(10.0), 2.0);
  EXPECT_DOUBLE_EQ(camera.DisparityOf(2.0), 10.0);
  EXPECT_DOUBLE_EQ(camera.DisparityOf(std::numeric_limits<double>::infinity()), -15.0);
}

TEST(StereoCameraTest, DisparitiesBeyondInfinityAreInfinitelyFar) {
  const StereoCamera camera = OddCamera();
  EXPECT_TRUE(std::isinf(camera.DepthOf(-camera.doffs)));
  EXPECT_TRUE(std::isinf(camera.DepthOf(-camera.doffs - 1.0)));
  EXPECT_GT(camera.DepthOf(-camera.doffs - 1.0), 0.0);
}

TEST(StereoCameraTest, PointsProjectBackToTheirPixels) {
  const StereoCamera camera = OddCamera();
  const Eigen::Vector3d point = camera.PointAt(100.0, 400.0, 20.0);
  EXPECT_NEAR(camera.focal_length * point.x() / point.z() + camera.cx, 100.0, 1e-9);
  EXPECT_NEAR(camera.focal_length * point.y() / point.z() + camera.cy, 400.0, 1e-9);
  const double x_right =
      camera.focal_length * (point.x() - camera.baseline) / point.z() + camera.cx + camera.doffs;
  EXPECT_NEAR(100.0 - x_right, 20.0, 1e-9);
}

TEST(StereoCameraTest, SpacePlaneHoldsThePointsOfTheDisparityPlane) {
  const StereoCamera camera = OddCamera();
  const std::vector<DisparityPlane> planes = {
      {0.0, 0.0, 40.0}, {0.1, 0.0, 20.0}, {-0.05, 0.2, 60.0}, {0.3, -0.3, 10.0}};
  for (const DisparityPlane& plane : planes) {
    const auto point_at = [&](double x, double y) { return camera.PointAt(x, y, plane.At(x, y)); };
    const StereoCamera::SpacePlane space = camera.ToSpace(plane);
    EXPECT_NEAR(space.normal.norm(), 1.0, 1e-12);
    const Eigen::Vector3d p = point_at(300.0, 200.0);
    const Eigen::Vector3d q = point_at(400.0, 220.0);
    const Eigen::Vector3d r = point_at(320.0, 310.0);
    Eigen::Vector3d normal = (q - p).cross(r - p).normalized();
    if (normal.dot(p) > 0.0) normal = -normal;
    EXPECT_TRUE(space.normal.isApprox(normal, 1e-9)) << space.normal.transpose();
    EXPECT_NEAR(space.distance, normal.dot(p), 1e-9);
    EXPECT_LT(space.distance, 0.0);
  }
}

TEST(StereoCameraTest, FrontoParallelPlaneFacesTheCameraAtItsDepth) {
  const StereoCamera camera = OddCamera();
  const StereoCamera::SpacePlane space = camera.ToSpace({0.0, 0.0, 40.0});
  EXPECT_TRUE(space.normal.isApprox(-Eigen::Vector3d::UnitZ()));
  EXPECT_NEAR(space.distance, -camera.DepthOf(40.0), 1e-12);
}

TEST(StereoCameraTest, GroundPlaneIsParallelToTheOpticalAxis) {
  const StereoCamera camera = OddCamera();
  const double height = 1.2;  // the ground lies at Y = height, seen from above
  const DisparityPlane plane = camera.ToDisparity({{0.0, -1.0, 0.0}, -height});
  EXPECT_NEAR(plane.a, 0.0, 1e-12);
  EXPECT_NEAR(plane.b, camera.baseline / height, 1e-12);
  EXPECT_NEAR(camera.PointAt(17.0, 450.0, plane.At(17.0, 450.0)).y(), height, 1e-9);
  const StereoCamera::SpacePlane back = camera.ToSpace(plane);
  EXPECT_TRUE(back.normal.isApprox(-Eigen::Vector3d::UnitY(), 1e-9));
  EXPECT_NEAR(back.distance, -height, 1e-9);
}

TEST(StereoCameraTest, PlaneConversionsAreInverse) {
  const StereoCamera camera = OddCamera();
  const DisparityPlane plane = {-0.07, 0.13, 25.0};
  const DisparityPlane back = camera.ToDisparity(camera.ToSpace(plane));
  EXPECT_NEAR(back.a, plane.a, 1e-12);
  EXPECT_NEAR(back.b, plane.b, 1e-12);
  EXPECT_NEAR(back.c, plane.c, 1e-9);
}

TEST(StereoCameraTest, BothSidesOfAPlaneHaveTheSameDisparities) {
  const StereoCamera camera = OddCamera();
  const StereoCamera::SpacePlane front = camera.ToSpace({0.02, 0.1, 30.0});
  const DisparityPlane same = camera.ToDisparity({-front.normal, -front.distance});
  EXPECT_NEAR(same.a, 0.02, 1e-12);
  EXPECT_NEAR(same.c, 30.0, 1e-9);
}

TEST(StereoCameraTest, PlaneAtInfinityRoundTrips) {
  const StereoCamera camera = OddCamera();
  const StereoCamera::SpacePlane space = camera.ToSpace({0.0, 0.0, -camera.doffs});
  EXPECT_TRUE(std::isinf(space.distance));
  const DisparityPlane plane = camera.ToDisparity(space);
  EXPECT_EQ(plane.a, 0.0);
  EXPECT_EQ(plane.b, 0.0);
  EXPECT_EQ(plane.c, -camera.doffs);
}

TEST(StereoCameraTest, PlaneThroughTheCameraIsRejected) {
  EXPECT_THROW(OddCamera().ToDisparity({Eigen::Vector3d::UnitX(), 0.0}), std::invalid_argument);
}

TEST(StereoCameraTest, CheckNamesTheImpossibleValue) {
  EXPECT_EQ(CheckMessage(OddCamera()), "");
  StereoCamera camera = OddCamera();
  camera.focal_length = 0.0;
  EXPECT_NE(CheckMessage(camera).find("focal_length of the stereo camera is 0"), std::string::npos);
  camera = OddCamera();
  camera.baseline = -0.1;
  EXPECT_NE(CheckMessage(camera).find("baseline of the stereo camera is -0.1"), std::string::npos);
  camera = OddCamera();
  camera.doffs = std::numeric_limits<double>::quiet_NaN();
  EXPECT_NE(CheckMessage(camera).find("doffs"), std::string::npos);
}

}  // namespace
}  // namespace stereo_sgmp
