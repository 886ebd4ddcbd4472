#include "prior/normals/normal_integration.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <map>
#include <random>
#include <set>
#include <stdexcept>

#include <gtest/gtest.h>

#include "prior/normals/normal_maps.h"

namespace stereo_sgmp {
namespace {

constexpr DisparityPlane kPlane{0.31, -0.22, 40.0};

IntegratedNormals Integrate(const cv::Mat& normals, const cv::Mat& discontinuities = cv::Mat(),
                            int threads = 2) {
  ThreadPool pool(threads);
  return IntegrateNormals(normals, discontinuities, OffCenterCamera(), &pool);
}

// The largest error of the disparities within `where`, pixels, with the scale of each component
// taken from the pixel of it that comes first.
double LargestError(const IntegratedNormals& result, const KnownSurface& known,
                    const cv::Rect& where) {
  const double doffs = OffCenterCamera().doffs;
  std::map<int, double> scales;
  double error = 0.0;
  for (int y = where.y; y < where.y + where.height; ++y) {
    for (int x = where.x; x < where.x + where.width; ++x) {
      const double e = std::exp(static_cast<double>(result.log_disparity(y, x)));
      const double expected = known.disparity(y, x) + doffs;
      const double scale = scales.emplace(result.component(y, x), expected / e).first->second;
      error = std::max(error, std::abs(scale * e - expected));
    }
  }
  return error;
}

double LargestError(const IntegratedNormals& result, const KnownSurface& known) {
  return LargestError(result, known, {0, 0, known.disparity.cols, known.disparity.rows});
}

std::set<int> Components(const IntegratedNormals& result) {
  return {result.component.begin(), result.component.end()};
}

TEST(IntegrateNormals, PlanesAreExact) {
  const KnownSurface known = PlaneSurface({150, 90}, kPlane, OffCenterCamera());
  const IntegratedNormals result = Integrate(known.normals);
  EXPECT_EQ(Components(result).count(0), 0U);
  EXPECT_LT(LargestError(result, known), 1e-4);
}

TEST(IntegrateNormals, MeanOfLogarithmIsZeroOverEachComponent) {
  const IntegratedNormals result =
      Integrate(PlaneSurface({150, 90}, kPlane, OffCenterCamera()).normals);
  for (const int component : Components(result)) {
    EXPECT_NEAR(cv::mean(result.log_disparity, result.component == component)[0], 0.0, 1e-6);
  }
}

TEST(IntegrateNormals, LengthAndSideOfNormalsDontMatter) {
  const KnownSurface known = PlaneSurface({40, 30}, kPlane, OffCenterCamera());
  EXPECT_LT(LargestError(Integrate(known.normals * -7.0), known), 1e-4);
}

TEST(IntegrateNormals, CurvedSurfaceIsCloseToTruth) {
  const StereoCamera camera = OffCenterCamera();
  const Eigen::Vector3d center(0.3, -0.14, 1.1);
  const double radius = 0.4;
  KnownSurface known({60, 50});
  for (int y = 0; y < 50; ++y) {
    for (int x = 0; x < 60; ++x) {
      const Eigen::Vector3d ray((x - camera.cx) / camera.focal_length,
                                (y - camera.cy) / camera.focal_length, 1.0);
      const double half = ray.dot(center) / ray.squaredNorm();
      const double distance = (center.squaredNorm() - radius * radius) / ray.squaredNorm();
      const double z = half - std::sqrt(half * half - distance);
      const Eigen::Vector3d n = (z * ray - center).normalized();
      known.normals(y, x) = cv::Vec3f(cv::Vec3d(n.x(), n.y(), n.z()));
      known.disparity(y, x) = camera.DisparityOf(z);
    }
  }
  double lowest = 0.0;
  double highest = 0.0;
  cv::minMaxLoc(known.disparity, &lowest, &highest);
  ASSERT_GT(highest - lowest, 4.0);
  EXPECT_LT(LargestError(Integrate(known.normals), known), 0.01);
}

// Of two parallel planes normals don't show where one ends.
TEST(IntegrateNormals, MarkedDiscontinuitySeparatesSurfaces) {
  const StereoCamera camera = OffCenterCamera();
  KnownSurface known = PlaneSurface({60, 40}, kPlane, camera);
  const double near = 2.0 * (kPlane.c + camera.doffs) - camera.doffs;
  known.Draw({30, 0, 30, 40}, {2.0 * kPlane.a, 2.0 * kPlane.b, near}, camera);
  EXPECT_EQ(Components(Integrate(known.normals)).size(), 1U);
  cv::Mat_<uchar> marked(known.normals.size(), 0);
  marked.colRange(29, 31).setTo(255);
  const IntegratedNormals result = Integrate(known.normals, marked);
  EXPECT_EQ(result.component(20, 28), result.component(0, 29));
  EXPECT_EQ(result.component(20, 31), result.component(0, 30));
  EXPECT_EQ(Components(result).size(), 2U);
  EXPECT_LT(LargestError(result, known), 1e-4);
}

TEST(IntegrateNormals, NormalsThatChangeAbruptlySeparateSurfaces) {
  const StereoCamera camera = OffCenterCamera();
  KnownSurface known = PlaneSurface({60, 40}, {0.02, 0.01, 40.0}, camera);
  known.Draw({30, 0, 30, 40}, {0.5, 0.01, 90.0}, camera);
  const cv::Vec3f change = known.normals(0, 29) - known.normals(0, 30);
  ASSERT_GT(cv::norm(change), 0.3);
  const IntegratedNormals result = Integrate(known.normals);
  EXPECT_EQ(Components(result).size(), 2U);
  EXPECT_NE(result.component(20, 29), result.component(20, 30));
  EXPECT_LT(LargestError(result, known), 1e-4);
}

TEST(IntegrateNormals, ContinuationsCarryThePlaneFromCellToCell) {
  const StereoCamera camera = OffCenterCamera();
  const KnownSurface known = PlaneSurface({150, 90}, kPlane, camera);
  const IntegratedNormals result = Integrate(known.normals);
  std::map<int, double> scale;  // log of the mean d + doffs
  for (int y = 0; y < 90; ++y) {
    for (int x = 0; x < 150; ++x) {
      scale[result.component(y, x)] =
          std::log(known.disparity(y, x) + camera.doffs) - result.log_disparity(y, x);
    }
  }
  ASSERT_EQ(scale.size(), 6U);
  EXPECT_EQ(result.continuations.size(), 2U * 7U);
  for (const IntegratedNormals::Continuation& c : result.continuations) {
    EXPECT_NE(IntegratedNormals::CellOf(c.from), IntegratedNormals::CellOf(c.to));
    EXPECT_NEAR(scale.at(c.to) - scale.at(c.from), c.offset, 1e-5);
  }
}

TEST(IntegrateNormals, WhatEndsAtTheBorderOfACellIsNotContinued) {
  const StereoCamera camera = OffCenterCamera();
  KnownSurface known = PlaneSurface({128, 64}, {0.02, 0.01, 40.0}, camera);
  known.Draw({64, 0, 64, 64}, {0.5, 0.01, 90.0}, camera);
  EXPECT_TRUE(Integrate(known.normals).continuations.empty());
}

// Around the face no constant fits, as the gap in depth varies. The error has to stay at the edges.
TEST(IntegrateNormals, UnmarkedDiscontinuityDoesNotBendSurfaces) {
  const StereoCamera camera = OffCenterCamera();
  KnownSurface known = PlaneSurface({60, 60}, kPlane, camera);
  known.Draw({15, 20, 30, 25}, {-0.4, 0.5, 60.0}, camera);
  const IntegratedNormals result = Integrate(known.normals);
  EXPECT_LT(LargestError(result, known, {17, 22, 26, 21}), 0.1);
  EXPECT_LT(LargestError(result, known, {0, 0, 60, 18}), 0.1);
}

TEST(IntegrateNormals, UnknownNormalsHaveNoComponent) {
  const float nan = std::numeric_limits<float>::quiet_NaN();
  const float infinity = std::numeric_limits<float>::infinity();
  KnownSurface known = PlaneSurface({12, 9}, kPlane, OffCenterCamera());
  known.normals(2, 3) = cv::Vec3f(0.0F, 0.0F, 0.0F);
  known.normals(4, 5) = cv::Vec3f(nan, 0.0F, -1.0F);
  known.normals(6, 7) = cv::Vec3f(0.0F, infinity, 0.0F);
  const IntegratedNormals result = Integrate(known.normals);
  EXPECT_EQ(result.component(2, 3), 0);
  EXPECT_EQ(result.component(4, 5), 0);
  EXPECT_EQ(result.component(6, 7), 0);
  EXPECT_EQ(cv::countNonZero(result.component), 12 * 9 - 3);
  EXPECT_TRUE(cv::checkRange(result.log_disparity));
}

// The ground reaches the horizon in row cy = 64.8, where d + doffs is 0.
TEST(IntegrateNormals, SurfaceSeenEdgeOnGivesNoAbsurdValues) {
  const cv::Mat_<cv::Vec3f> normals(128, 20, cv::Vec3f(0.0F, -1.0F, 0.0F));
  const IntegratedNormals result = Integrate(normals);
  EXPECT_EQ(cv::countNonZero(result.component.rowRange(63, 68)), 0);
  EXPECT_TRUE(cv::checkRange(result.log_disparity, true, nullptr, -5.0, 5.0));
  for (int y = 71; y < 128; ++y) {
    const double steps = result.log_disparity(y, 4) - result.log_disparity(y - 1, 4);
    EXPECT_NEAR(steps, std::log((y - 64.8) / (y - 65.8)), 1e-5);
  }
}

// n.(u, v, f) changes its sign between the columns 9 and 10.
TEST(IntegrateNormals, SidesOfPlaneThroughCameraAreNotConnected) {
  StereoCamera camera = OffCenterCamera();
  camera.focal_length = 40.0;
  camera.cx = 10.0;
  camera.cy = 5.0;
  const cv::Mat_<cv::Vec3f> normals(10, 20, cv::Vec3f(1.0F, 0.0F, 0.0125F));
  ThreadPool pool(1);
  const IntegratedNormals result = IntegrateNormals(normals, cv::Mat(), camera, &pool);
  EXPECT_EQ(cv::countNonZero(result.component), 200);
  EXPECT_NE(result.component(5, 9), result.component(5, 10));
}

TEST(IntegrateNormals, SameBitsOnAnyNumberOfThreads) {
  KnownSurface known = PlaneSurface({170, 140}, kPlane, OffCenterCamera());
  std::mt19937 random(3);
  std::normal_distribution<float> noise(0.0F, 0.05F);
  for (cv::Vec3f& n : known.normals) n += cv::Vec3f(noise(random), noise(random), noise(random));
  const IntegratedNormals one = Integrate(known.normals, cv::Mat(), 1);
  const IntegratedNormals four = Integrate(known.normals, cv::Mat(), 4);
  EXPECT_EQ(cv::countNonZero(one.log_disparity != four.log_disparity), 0);
  EXPECT_EQ(cv::countNonZero(one.component != four.component), 0);
  // Slopes average over the noise.
  EXPECT_LT(LargestError(one, known), 3.0);
}

TEST(IntegrateNormals, RefusesMalformedInput) {
  const cv::Mat normals = PlaneSurface({12, 9}, kPlane, OffCenterCamera()).normals;
  EXPECT_THROW(Integrate(cv::Mat()), std::invalid_argument);
  EXPECT_THROW(Integrate(cv::Mat(9, 12, CV_32FC1)), std::invalid_argument);
  EXPECT_THROW(Integrate(cv::Mat(9, 12, CV_64FC3)), std::invalid_argument);
  EXPECT_THROW(Integrate(cv::Mat::zeros(9, 12, CV_32FC3)), std::invalid_argument);
  EXPECT_THROW(Integrate(normals, cv::Mat(9, 11, CV_8UC1)), std::invalid_argument);
  EXPECT_THROW(Integrate(normals, cv::Mat(9, 12, CV_32FC1)), std::invalid_argument);
  ThreadPool pool(1);
  EXPECT_THROW(IntegrateNormals(normals, cv::Mat(), StereoCamera(), &pool), std::invalid_argument);
}

}  // namespace
}  // namespace stereo_sgmp
