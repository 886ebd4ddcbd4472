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
const cv::Rect kFrontArea(71, 18, 127, 121);

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

PlacedSurfaces PlaceBy(const cv::Mat& image, const KnownSurface& known, const CoarseMap& coarse,
                       int threads = 2) {
  ThreadPool pool(threads);
  const IntegratedNormals normals =
      IntegrateNormals(known.normals, cv::Mat(), OffCenterCamera(), &pool);
  return PlaceSurfaces(normals, {coarse.disparity, coarse.confident}, image,
                       OffCenterCamera().doffs, &pool);
}

// Nothing is seen in the image.
cv::Mat_<float> Place(const KnownSurface& known, const CoarseMap& coarse, int threads = 2) {
  return PlaceBy(cv::Mat(kSize, CV_8UC1, cv::Scalar(90)), known, coarse, threads).disparity;
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

// Two surfaces that face the camera. The coarse disparities of the front one reach two coarse
// pixels too far, and what is hidden from the right camera isn't confident, nor an end of the front
// one.
class ParallelSurfaces : public testing::Test {
 protected:
  ParallelSurfaces() {
    known_.Draw(kFrontArea, {0.0, 0.0, 90.0}, OffCenterCamera());
    coarse_ = CoarseMap(known_);
    cv::dilate(coarse_.disparity, coarse_.disparity, cv::Mat::ones(3, 3, CV_8U));
    coarse_.confident(cv::Rect(9, 0, 10, 40)).setTo(0);
    coarse_.confident(cv::Rect(40, 20, 14, 20)).setTo(0);
    cv::randu(image_, 90, 100);
    cv::Mat_<cv::Vec3b> front = image_(kFrontArea);
    cv::randu(front, 115, 125);
  }

  KnownSurface known_ = PlaneSurface(kSize, {0.0, 0.0, 30.0}, OffCenterCamera());
  CoarseMap coarse_{known_};
  cv::Mat_<cv::Vec3b> image_{kSize};
};

TEST_F(ParallelSurfaces, StepWhereTheImageDoes) {
  cv::Mat placed;
  PlaceBy(image_, known_, coarse_).disparity.convertTo(placed, CV_64F);
  // An edge is as wide as the pixels to both sides of it.
  cv::Mat_<uchar> beside_edges(kSize, uchar{255});
  cv::rectangle(beside_edges, kFrontArea, cv::Scalar(0), 3);
  EXPECT_LT(cv::norm(placed, known_.disparity, cv::NORM_INF, beside_edges), 0.5);
}

TEST_F(ParallelSurfaces, AreNoLongerOfOneComponent) {
  const PlacedSurfaces placed = PlaceBy(image_, known_, coarse_);
  for (int y = 0; y < kSize.height; ++y) {
    for (int x = 1; x < kSize.width; ++x) {
      const int p = placed.component(y, x - 1);
      const int q = placed.component(y, x);
      if (IntegratedNormals::CellOf(p) != IntegratedNormals::CellOf(q)) continue;
      const bool steps = std::abs(placed.disparity(y, x) - placed.disparity(y, x - 1)) > 30.0F;
      ASSERT_EQ(p != q, steps) << x << ", " << y;
    }
  }
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
  cv::Mat image(kSize, CV_8UC3);
  cv::randu(image, 0, 255);
  const PlacedSurfaces one = PlaceBy(image, known, coarse, 1);
  const PlacedSurfaces three = PlaceBy(image, known, coarse, 3);
  EXPECT_EQ(cv::norm(one.disparity, three.disparity, cv::NORM_INF), 0.0);
  EXPECT_EQ(cv::norm(one.component, three.component, cv::NORM_INF), 0.0);
}

}  // namespace
}  // namespace stereo_sgmp
