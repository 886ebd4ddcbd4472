#include "geometry/pcl/cloud_filter.h"

#include <cmath>
#include <limits>

#include <gtest/gtest.h>

namespace stereo_sgmp {
namespace {

constexpr float kNan = std::numeric_limits<float>::quiet_NaN();

// A wall of 40 x 30 points one metre away, 1 cm apart, and one point of each kind that filters
// drop: an invalid one and one far from all others.
PointCloud Wall() {
  PointCloud cloud;
  cloud.width = 40;
  cloud.height = 30;
  for (int y = 0; y < cloud.height; ++y) {
    for (int x = 0; x < cloud.width; ++x) {
      cloud.points.push_back({0.01F * static_cast<float>(x), 0.01F * static_cast<float>(y), 1.0F,
                              10, 20, 30, 0, 0.5F});
    }
  }
  cloud.points[0] = {kNan, kNan, kNan, 0, 0, 0, 0, 0.1F};
  cloud.points[500].z = 0.5F;
  return cloud;
}

TEST(FilterCloudTest, DropsInvalidPointsOnly) {
  const PointCloud filtered = FilterCloud(Wall(), CloudFilterOptions());
  EXPECT_EQ(filtered.width, 40 * 30 - 1);
  EXPECT_EQ(filtered.height, 1);
  ASSERT_EQ(filtered.points.size(), 40u * 30u - 1u);
  EXPECT_FLOAT_EQ(filtered.points[0].x, 0.01F);
  EXPECT_EQ(filtered.points[0].g, 20);
  EXPECT_EQ(filtered.points[0].confidence, 0.5F);
}

TEST(FilterCloudTest, VoxelsBecomeTheMeanOfTheirPoints) {
  CloudFilterOptions options;
  options.voxel_size = 0.1;
  const PointCloud filtered = FilterCloud(Wall(), options);
  // The wall spans 4 x 3 voxels, and touches the next ones; the outlier has one of its own.
  EXPECT_GE(filtered.width, 13);
  EXPECT_LE(filtered.width, 21);
  int on_wall = 0;
  for (const CloudPoint& point : filtered.points) {
    EXPECT_EQ(point.b, 10);
    EXPECT_EQ(point.g, 20);
    EXPECT_EQ(point.r, 30);
    EXPECT_FLOAT_EQ(point.confidence, 0.5F);
    if (std::abs(point.z - 1.0F) < 1e-5F) ++on_wall;
  }
  EXPECT_EQ(on_wall, filtered.width - 1);
}

TEST(FilterCloudTest, DropsOutliers) {
  CloudFilterOptions options;
  options.outlier_neighbors = 8;
  options.outlier_deviations = 3.0;
  const PointCloud filtered = FilterCloud(Wall(), options);
  EXPECT_GT(filtered.width, 1100);
  for (const CloudPoint& point : filtered.points) EXPECT_FLOAT_EQ(point.z, 1.0F);
}

TEST(FilterCloudTest, TakesCloudsWithoutPoints) {
  CloudFilterOptions options;
  options.voxel_size = 0.1;
  options.outlier_neighbors = 8;
  PointCloud invalid;
  invalid.width = invalid.height = 1;
  invalid.points = {{kNan, kNan, kNan, 0, 0, 0, 0, 0.1F}};
  for (const PointCloud& cloud : {PointCloud(), invalid}) {
    EXPECT_EQ(FilterCloud(cloud, options).width, 0);
  }
}

}  // namespace
}  // namespace stereo_sgmp
