#include "prior/normals/surface_placement.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include <gtest/gtest.h>
#include <opencv2/imgproc.hpp>

#include "prior/normals/normal_maps.h"

namespace stereo_sgmp {
namespace {

constexpr int kRatio = 4;
const cv::Size kSize(256, 160);
constexpr DisparityPlane kWall{0.12, -0.05, 30.0};
constexpr DisparityPlane kFront{-0.3, 0.1, 120.0};

// A coarse map of what is known exactly, all of it confident.
struct CoarseMap {
  explicit CoarseMap(const KnownSurface& known) {
    cv::Mat mean;
    cv::resize(known.disparity, mean, kSize / kRatio, 0.0, 0.0, cv::INTER_AREA);
    mean.convertTo(disparity, CV_32F, 1.0 / kRatio);
    confident.create(disparity.size());
    confident.setTo(255);
  }

  cv::Mat_<float> disparity;
  cv::Mat_<uchar> confident;
};

cv::Mat_<float> Place(const KnownSurface& known, const CoarseMap& coarse, int threads = 2) {
  ThreadPool pool(threads);
  const IntegratedNormals normals =
      IntegrateNormals(known.normals, cv::Mat(), OffCenterCamera(), &pool);
  return PlaceSurfaces(normals, {coarse.disparity, coarse.confident}, OffCenterCamera().doffs,
                       &pool);
}

double LargestError(const cv::Mat_<float>& placed, const KnownSurface& known,
                    const cv::Rect& where) {
  cv::Mat exact;
  placed(where).convertTo(exact, CV_64F);
  return cv::norm(exact, known.disparity(where), cv::NORM_INF);
}

TEST(PlaceSurfaces, SurfacesLieWhereTheCoarseDisparitiesAre) {
  KnownSurface known = PlaneSurface(kSize, kWall, OffCenterCamera());
  known.Draw({100, 30, 90, 100}, kFront, OffCenterCamera());
  const cv::Mat_<float> placed = Place(known, CoarseMap(known));
  EXPECT_LT(LargestError(placed, known, {cv::Point(), kSize}), 0.3);
}

// As with a fence, whose bars are thin. What is seen of them in the uppermost cell is wrong, and of
// the wall beside it.
TEST(PlaceSurfaces, WhatGoesOnInOtherCellsOutvotesWrongDisparities) {
  KnownSurface known = PlaneSurface(kSize, kWall, OffCenterCamera());
  const cv::Rect bar(80, 0, 8, kSize.height);
  known.Draw(bar, kFront, OffCenterCamera());
  CoarseMap coarse(known);
  cv::randu(coarse.disparity(cv::Rect(20, 0, 12, 13)), 0.0, 30.0);
  const cv::Mat_<float> placed = Place(known, coarse);
  EXPECT_LT(LargestError(placed, known, bar), 0.5);
  EXPECT_LT(LargestError(placed, known, {88, 0, 60, kSize.height}), 0.5);
}

TEST(PlaceSurfaces, ParallelSurfacesOneBehindTheOtherAreToldApart) {
  const StereoCamera camera = OffCenterCamera();
  KnownSurface known = PlaneSurface(kSize, kWall, camera);
  // The same normal, at three times d + doffs.
  const DisparityPlane near{3.0 * kWall.a, 3.0 * kWall.b,
                            3.0 * (kWall.c + camera.doffs) - camera.doffs};
  const cv::Rect front(70, 20, 120, 120);
  known.Draw(front, near, camera);
  const cv::Mat_<float> placed = Place(known, CoarseMap(known));
  EXPECT_LT(LargestError(placed, known, {78, 28, 104, 104}), 0.5);
  EXPECT_LT(LargestError(placed, known, {0, 0, 60, kSize.height}), 0.5);
}

TEST(PlaceSurfaces, WhereNothingIsConfidentNothingIsPlaced) {
  const KnownSurface known = PlaneSurface(kSize, kWall, OffCenterCamera());
  CoarseMap coarse(known);
  coarse.confident.setTo(0);
  EXPECT_TRUE(std::isnan(cv::sum(Place(known, coarse))[0]));
  coarse.confident.setTo(255);
  coarse.disparity.setTo(std::numeric_limits<float>::quiet_NaN());
  const cv::Mat_<float> placed = Place(known, coarse);
  EXPECT_TRUE(std::all_of(placed.begin(), placed.end(), [](float d) { return std::isnan(d); }));
}

TEST(PlaceSurfaces, SameBitsOnAnyNumberOfThreads) {
  KnownSurface known = PlaneSurface(kSize, kWall, OffCenterCamera());
  known.Draw({100, 30, 90, 100}, kFront, OffCenterCamera());
  CoarseMap coarse(known);
  cv::randu(coarse.disparity(cv::Rect(0, 0, 40, 20)), 0.0, 30.0);
  const cv::Mat_<float> one = Place(known, coarse, 1);
  EXPECT_EQ(cv::norm(one, Place(known, coarse, 3), cv::NORM_INF), 0.0);
}

}  // namespace
}  // namespace stereo_sgmp
