#include "prior/normals/surface_family.h"

#include <algorithm>
#include <cmath>
#include <stdexcept>

#include <gtest/gtest.h>

namespace stereo_sgmp {
namespace {

// e runs from 1/2 to 2 along the row.
IntegratedNormals SlantedRow() {
  IntegratedNormals normals;
  normals.log_disparity.create(1, 101);
  for (int x = 0; x <= 100; ++x) {
    normals.log_disparity(0, x) = static_cast<float>(std::log(2.0) * (x - 50) / 50.0);
  }
  normals.component = cv::Mat_<int>::ones(1, 101);
  return normals;
}

TEST(SurfacesAtAllDepths, CoverTheRangeAtEveryPixel) {
  const SurfaceFamily family = SurfacesAtAllDepths(SlantedRow(), 30.0, 10, 200);
  for (const float e : family.shape) {
    EXPECT_LE(family.At(family.scales.front(), e), 10.0F + 1e-3F);
    EXPECT_GE(family.At(family.scales.back(), e), 209.0F);
  }
}

TEST(SurfacesAtAllDepths, DistanceGrowsWithDisparityPlusDoffs) {
  const SurfaceFamily family = SurfacesAtAllDepths(SlantedRow(), 0.0, 0, 200);
  ASSERT_GT(family.scales.size(), 6U);
  EXPECT_GT(family.scales.front(), 0.0F);
  EXPECT_LE(family.scales.front(), 8.0F);
  for (std::size_t k = 1; k < family.scales.size(); ++k) {
    const float before = family.scales[k - 1];
    EXPECT_NEAR(family.scales[k] - before, std::max(16.0F, 0.3F * before), 1e-3F);
  }
}

TEST(SurfacesAtAllDepths, SurfacesAreTheShapeScaledInDisparityPlusDoffs) {
  const SurfaceFamily family = SurfacesAtAllDepths(SlantedRow(), 30.0, 0, 200);
  EXPECT_FLOAT_EQ(family.shape(0, 0), 0.5F);
  EXPECT_FLOAT_EQ(family.shape(0, 100), 2.0F);
  EXPECT_FLOAT_EQ(family.At(100.0F, 0.5F), 20.0F);
}

TEST(SurfacesAtAllDepths, NumberIsBoundedForAnyShape) {
  IntegratedNormals normals = SlantedRow();
  normals.log_disparity *= 100.0;
  const SurfaceFamily family = SurfacesAtAllDepths(normals, 0.0, 0, 200);
  EXPECT_EQ(family.scales.size(), std::size_t{SurfaceFamily::kMaxSurfaces});
}

TEST(SurfacesAtAllDepths, RefusesRangeBehindTheCamera) {
  EXPECT_NO_THROW(SurfacesAtAllDepths(SlantedRow(), -98.0, 0, 100));
  EXPECT_THROW(SurfacesAtAllDepths(SlantedRow(), -99.0, 0, 100), std::invalid_argument);
}

TEST(SurfaceAtDepth, HasTheMeanAskedFor) {
  const SurfaceFamily family = SurfaceAtDepth(SlantedRow(), 30.0, 50.0);
  ASSERT_EQ(family.scales.size(), 1U);
  EXPECT_FLOAT_EQ(family.At(family.scales[0], family.shape(0, 50)), 50.0F);
}

TEST(SurfaceAtDepth, RefusesDepthBehindTheCamera) {
  EXPECT_THROW(SurfaceAtDepth(SlantedRow(), 0.0, 0.0), std::invalid_argument);
  EXPECT_THROW(SurfaceAtDepth(SlantedRow(), -60.0, 50.0), std::invalid_argument);
}

}  // namespace
}  // namespace stereo_sgmp
