#include "prior/coarse_scale.h"

#include <gtest/gtest.h>

namespace stereo_sgmp {
namespace {

TEST(CoarseScale, PlaneHoldsAtCorrespondingPixels) {
  const CoarseScale scale = CoarseScale::Between({1441, 995}, {360, 249});
  const DisparityPlane coarse{0.3, -0.2, 11.0};
  const DisparityPlane full = scale.ToFull(coarse);
  for (const double u : {0.0, 17.0, 1440.0}) {
    for (const double v : {0.0, 400.0, 994.0}) {
      const double x = (u + 0.5) * 360 / 1441 - 0.5;
      const double y = (v + 0.5) * 249 / 995 - 0.5;
      EXPECT_NEAR(full.At(u, v), coarse.At(x, y) * 1441 / 360, 1e-9);
    }
  }
}

TEST(CoarseScale, EqualsScaledUpForOneFactor) {
  const DisparityPlane coarse{0.3, -0.2, 11.0};
  const DisparityPlane full = CoarseScale::Between({400, 200}, {100, 50}).ToFull(coarse);
  const DisparityPlane expected = coarse.ScaledUp(4.0);
  EXPECT_NEAR(full.a, expected.a, 1e-12);
  EXPECT_NEAR(full.b, expected.b, 1e-12);
  EXPECT_NEAR(full.c, expected.c, 1e-12);
}

TEST(CoarseScale, ToCoarseIsTheWayBack) {
  const CoarseScale scale = CoarseScale::Between({1441, 995}, {360, 249});
  const DisparityPlane coarse{0.3, -0.2, 11.0};
  const DisparityPlane back = scale.ToCoarse(scale.ToFull(coarse));
  EXPECT_NEAR(back.a, coarse.a, 1e-12);
  EXPECT_NEAR(back.b, coarse.b, 1e-12);
  EXPECT_NEAR(back.c, coarse.c, 1e-12);
}

}  // namespace
}  // namespace stereo_sgmp
