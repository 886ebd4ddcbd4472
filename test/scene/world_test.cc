#include "scene/world.h"

#include <cmath>

#include <gtest/gtest.h>

#include "scene/ground_truth.h"
#include "scene/renderer.h"
#include "scene/world_builder.h"

namespace stereo_sgmp {
namespace {

using Eigen::Vector3d;

const PinholeView kView{100.0, 79.5, 59.5, Vector3d(0.1, -0.2, 0.3)};
constexpr int kWidth = 160;
constexpr int kHeight = 120;

// The distance of the camera from a surface whose centre its middle ray goes through.
double MiddleDepth(const World& world) {
  const PinholeView view{100.0, 0.0, 0.0, Vector3d::Zero()};
  const Hit hit = WorldView(world, view).Cast(0.0, 0.0);
  return hit.surface < 0 ? 0.0 : 1.0 / hit.point.w;
}

TEST(WorldView, MeetsTheNearestPointOfASphere) {
  WorldBuilder builder;
  builder.AddSphere({0.0, 0.0, 5.0}, 2.0, {});
  EXPECT_NEAR(MiddleDepth(builder.world()), 3.0, 1e-12);
  builder.AddFacingZ(-1, 1, -1, 1, 2.5, {});
  EXPECT_NEAR(MiddleDepth(builder.world()), 2.5, 1e-12);
}

TEST(WorldView, MeetsTheFarSideOfAColumnAroundTheCamera) {
  WorldBuilder builder;
  builder.AddColumn({0.0, 0.0, 1.0}, 3.0, -1.0, 1.0, {});
  EXPECT_NEAR(MiddleDepth(builder.world()), 4.0, 1e-12);
}

TEST(WorldView, PointsAndNormalsAreThoseOfTheQuadric) {
  const Vector3d center(0.2, 0.1, 4.0);
  constexpr double kRadius = 1.1;
  WorldBuilder sphere;
  sphere.AddSphere(center, kRadius, {});
  WorldBuilder column;
  column.AddColumn(center, kRadius, -1.0, 0.8, {});
  column.Turn(0.2, 0.1, -0.3);
  const Vector3d axis = column.world().rotation.col(1);
  const Vector3d on_axis = column.world().rotation * center;
  int hits = 0;
  for (int y = 0; y < kHeight; ++y) {
    for (int x = 0; x < kWidth; ++x) {
      const WorldView sphere_view(sphere.world(), kView);
      const Hit on_sphere = sphere_view.Cast(x, y);
      if (on_sphere.surface >= 0) {
        const Vector3d offset = sphere_view.PointAt(on_sphere, x, y) - center;
        ASSERT_NEAR(offset.norm(), kRadius, 1e-9);
        ASSERT_LT((sphere_view.NormalAt(on_sphere, x, y) - offset / kRadius).norm(), 1e-9);
        ++hits;
      }
      const WorldView column_view(column.world(), kView);
      const Hit on_column = column_view.Cast(x, y);
      if (on_column.surface >= 0) {
        const Vector3d point = column_view.PointAt(on_column, x, y);
        const Vector3d offset = point - on_axis;
        const double height = axis.dot(offset) + center.y();  // of the world it was built in
        ASSERT_NEAR((offset - axis.dot(offset) * axis).norm(), kRadius, 1e-9);
        ASSERT_GE(height, -1.0 - 1e-9);
        ASSERT_LE(height, 0.8 + 1e-9);
        const Vector3d normal = column_view.NormalAt(on_column, x, y);
        ASSERT_NEAR(normal.dot(axis), 0.0, 1e-9);
        ASSERT_LT(normal.dot(point - kView.center), 1e-9);
        ++hits;
      }
    }
  }
  EXPECT_GT(hits, 4000);
}

// Seen head-on, a pixel covers z / f metres.
TEST(WorldView, FootprintIsTheDistanceBetweenPixelsOnTheSurface) {
  WorldBuilder builder;
  builder.AddSphere({0.0, 0.0, 5.0}, 2.0, {});
  builder.AddFacingZ(-1, 1, -1, 1, 2.5, {});
  const PinholeView view{100.0, 0.0, 0.0, Vector3d::Zero()};
  const WorldView world_view(builder.world(), view);
  EXPECT_NEAR(world_view.Footprint(world_view.Cast(0, 0), 0, 0), 0.025, 1e-12);
  World sphere = builder.world();
  sphere.patches.clear();
  const WorldView sphere_view(sphere, view);
  EXPECT_NEAR(sphere_view.Footprint(sphere_view.Cast(0, 0), 0, 0), 0.03, 1e-12);
}

TEST(WorldBuilder, TurnsRightUpAndClockwise) {
  const auto forward = [](double yaw, double pitch) {
    WorldBuilder builder;
    builder.Turn(yaw, pitch, 0.0);
    return Vector3d(builder.world().rotation.col(2));
  };
  EXPECT_GT(forward(0.1, 0.0).x(), 0.09);
  EXPECT_LT(forward(0.0, 0.1).y(), -0.09);
  WorldBuilder rolled;
  rolled.Turn(0.0, 0.0, 0.1);
  EXPECT_GT(rolled.world().rotation(1, 0), 0.09) << "what points right points down";
}

TEST(RenderView, IsTheSameOnAnyNumberOfThreads) {
  WorldBuilder builder;
  builder.AddFacingZ(-9, 9, -9, 9, 6.0, {});
  builder.AddSphere({0.0, 0.0, 4.0}, 0.7, {});
  builder.AddColumn({1.0, 0.0, 5.0}, 0.4, -1.0, 1.0, {});
  const cv::Size size(kWidth, kHeight);
  StereoCamera camera;
  camera.focal_length = 100.0;
  camera.cx = 79.5;
  camera.cy = 59.5;
  camera.baseline = 0.2;
  const ValueNoise noise(1);
  ThreadPool one(1);
  ThreadPool three(3);
  const auto difference = [](const cv::Mat& a, const cv::Mat& b) {
    return cv::norm(a, b, cv::NORM_INF);
  };
  const auto picture = [&](ThreadPool* pool) {
    return RenderView(builder.world(), LeftView(camera), size, {}, noise, pool);
  };
  EXPECT_EQ(difference(picture(&one), picture(&three)), 0);
  const GroundTruth a = RenderGroundTruth(builder.world(), camera, {}, size, &one);
  const GroundTruth b = RenderGroundTruth(builder.world(), camera, {}, size, &three);
  EXPECT_EQ(difference(a.disparity, b.disparity), 0);
  EXPECT_EQ(difference(a.mask, b.mask), 0);
  EXPECT_EQ(difference(a.normals, b.normals), 0);
  EXPECT_EQ(difference(a.labels, b.labels), 0);
}

TEST(RenderGroundTruth, LeavesNothingWhereNothingIsSeen) {
  WorldBuilder builder;
  builder.AddFacingZ(5, 6, -1, 1, 6.0, {});   // out of sight: no plane
  builder.AddFacingZ(-1, 1, -1, 1, 4.0, {});  // the one plane
  StereoCamera camera;
  camera.focal_length = 100.0;
  camera.cx = 79.5;
  camera.cy = 59.5;
  camera.baseline = 0.2;
  ThreadPool pool(1);
  const GroundTruth truth =
      RenderGroundTruth(builder.world(), camera, {}, {kWidth, kHeight}, &pool);
  ASSERT_EQ(truth.planes.size(), 1U);
  EXPECT_EQ(truth.labels.at<std::int16_t>(60, 80), 0);
  EXPECT_EQ(truth.normals.at<cv::Vec3f>(60, 80), cv::Vec3f(0, 0, -1));
  EXPECT_NEAR(truth.planes[0].At(80, 60), 5.0, 1e-9);
  EXPECT_EQ(truth.labels.at<std::int16_t>(0, 0), -1);
  EXPECT_EQ(truth.normals.at<cv::Vec3f>(0, 0), cv::Vec3f(0, 0, 0));
  EXPECT_TRUE(std::isinf(truth.disparity.at<float>(0, 0)));
  EXPECT_EQ(truth.mask.at<std::uint8_t>(0, 0), 0);
}

}  // namespace
}  // namespace stereo_sgmp
