#include "stereo_sgmp/prior_polygons.h"

#include <cmath>
#include <cstdint>
#include <stdexcept>

#include <gtest/gtest.h>

namespace stereo_sgmp {
namespace {

constexpr double kFar = 1000.0;
const cv::Size kImage(400, 300);

StereoCamera Camera() {
  StereoCamera camera;
  camera.focal_length = 500.0;
  camera.baseline = 0.1;
  camera.cx = 200.0;
  camera.cy = 150.0;
  return camera;
}

// Labels of a quarter of the image's size without any plane.
PlanePriors NoPlanes() {
  PlanePriors priors;
  priors.labels = cv::Mat(75, 100, CV_16S, cv::Scalar(-1));
  return priors;
}

void AddPlane(const DisparityPlane& plane, const cv::Rect& pixels, PlanePriors* priors) {
  priors->labels(pixels).setTo(static_cast<int>(priors->planes.size()));
  priors->planes.push_back({plane, 0, 0.0});
}

TEST(PriorPolygonsTest, CornersLieOnThePlaneAndAroundItsPixels) {
  PlanePriors priors = NoPlanes();
  const DisparityPlane plane{0.05, -0.02, 20.0};
  AddPlane(plane, {10, 20, 30, 40}, &priors);
  const StereoCamera camera = Camera();
  const auto polygons = PriorPolygons(priors, kImage, camera, kFar);
  ASSERT_EQ(polygons.size(), 1u);
  EXPECT_EQ(polygons[0].plane, 0u);
  ASSERT_EQ(polygons[0].corners.size(), 4u);
  const StereoCamera::SpacePlane space = camera.ToSpace(plane);
  double left = 1e9;
  double right = -1e9;
  for (const Eigen::Vector3d& corner : polygons[0].corners) {
    EXPECT_NEAR(space.normal.dot(corner), space.distance, 1e-9);
    const double x = camera.focal_length * corner.x() / corner.z() + camera.cx;
    left = std::min(left, x);
    right = std::max(right, x);
  }
  EXPECT_NEAR(left, 4 * 10 - 0.5, 1e-9);
  EXPECT_NEAR(right, 4 * 40 - 0.5, 1e-9);
}

TEST(PriorPolygonsTest, CutsWhatIsTooFar) {
  PlanePriors priors = NoPlanes();
  // A floor up to its horizon in the middle of the image, and beyond it.
  AddPlane({0.0, 0.2, -0.2 * 150.0}, {0, 0, 100, 75}, &priors);
  const auto polygons = PriorPolygons(priors, kImage, Camera(), 12.0);
  ASSERT_EQ(polygons.size(), 1u);
  double farthest = 0.0;
  for (const Eigen::Vector3d& corner : polygons[0].corners) {
    EXPECT_GT(corner.z(), 0.0);
    farthest = std::max(farthest, corner.z());
  }
  EXPECT_NEAR(farthest, 12.0, 1e-9);
}

TEST(PriorPolygonsTest, LeavesOutPlanesThatShowNothing) {
  PlanePriors priors = NoPlanes();
  AddPlane({0.0, 0.0, 30.0}, {0, 0, 50, 75}, &priors);
  AddPlane({0.0, 0.0, 20.0}, {0, 0, 0, 0}, &priors);
  AddPlane({0.0, 0.0, 0.001}, {50, 0, 25, 75}, &priors);  // 50 km away
  AddPlane({0.0, 0.0, 10.0}, {75, 0, 25, 75}, &priors);
  const auto polygons = PriorPolygons(priors, kImage, Camera(), kFar);
  ASSERT_EQ(polygons.size(), 2u);
  EXPECT_EQ(polygons[0].plane, 0u);
  EXPECT_EQ(polygons[1].plane, 3u);
}

TEST(PriorPolygonsTest, NoPlanesNoPolygons) {
  EXPECT_TRUE(PriorPolygons(PlanePriors(), kImage, Camera(), kFar).empty());
  EXPECT_TRUE(PriorPolygons(NoPlanes(), kImage, Camera(), kFar).empty());
}

TEST(PriorPolygonsTest, RefusesWhatIsNoDepth) {
  EXPECT_THROW(PriorPolygons(NoPlanes(), kImage, Camera(), 0.0), std::invalid_argument);
}

}  // namespace
}  // namespace stereo_sgmp
