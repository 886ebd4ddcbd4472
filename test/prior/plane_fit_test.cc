#include "prior/plane_fit.h"

#include <vector>

#include <gtest/gtest.h>

namespace stereo_sgmp {
namespace {

constexpr DisparityPlane kPlane{0.25, -0.125, 17.0};

std::vector<DisparitySample> SamplesOf(const DisparityPlane& plane, int side, float x0) {
  std::vector<DisparitySample> samples;
  for (int y = 0; y < side; ++y) {
    for (int x = 0; x < side; ++x) {
      const float u = x0 + static_cast<float>(x);
      const float v = static_cast<float>(y);
      samples.push_back({u, v, static_cast<float>(plane.At(u, v))});
    }
  }
  return samples;
}

PlaneMoments MomentsOf(const std::vector<DisparitySample>& samples) {
  PlaneMoments moments;
  for (const DisparitySample& s : samples) moments.Add(s.x, s.y, s.disparity);
  return moments;
}

void ExpectNear(const DisparityPlane& plane, const DisparityPlane& expected, double slope_error,
                double error) {
  EXPECT_NEAR(plane.a, expected.a, slope_error);
  EXPECT_NEAR(plane.b, expected.b, slope_error);
  EXPECT_NEAR(plane.c, expected.c, error);
}

TEST(PlaneFit, RecoversPlaneFarFromOrigin) {
  const auto samples = SamplesOf(kPlane, 20, 4000.0F);
  const PlaneMoments moments = MomentsOf(samples);
  const DisparityPlane plane = moments.Fit();
  EXPECT_NEAR(plane.At(4010, 10), kPlane.At(4010, 10), 1e-4);
  EXPECT_NEAR(plane.a, kPlane.a, 1e-4);
  EXPECT_NEAR(moments.Rms(plane), 0.0, 1e-2);
}

TEST(PlaneFit, MergedMomentsAreThoseOfAllSamples) {
  auto left = SamplesOf(kPlane, 8, 0.0F);
  const auto right = SamplesOf({0.0, 0.5, 3.0}, 8, 8.0F);
  PlaneMoments merged = MomentsOf(left);
  merged.Merge(MomentsOf(right));
  left.insert(left.end(), right.begin(), right.end());
  const PlaneMoments all = MomentsOf(left);
  EXPECT_EQ(merged.weight(), all.weight());
  ExpectNear(merged.Fit(), all.Fit(), 1e-9, 1e-9);
}

TEST(PlaneFit, RmsIsDistanceFromGivenPlane) {
  const PlaneMoments moments = MomentsOf(SamplesOf(kPlane, 10, 0.0F));
  EXPECT_NEAR(moments.Rms({kPlane.a, kPlane.b, kPlane.c + 2.0}), 2.0, 1e-6);
}

TEST(PlaneFit, PointAndLineAreFlat) {
  PlaneMoments point;
  point.Add(100.0, 50.0, 7.0);
  EXPECT_NEAR(point.Fit().At(130, 90), 7.0, 1e-9);
  PlaneMoments line;
  for (int x = 0; x < 10; ++x) line.Add(x, 5.0, 0.5 * x);
  EXPECT_NEAR(line.Fit().a, 0.5, 1e-3);
  EXPECT_NEAR(line.Fit().b, 0.0, 1e-9);
  EXPECT_EQ(PlaneMoments().Fit().c, 0.0);
}

TEST(PlaneFit, HuberResistsAStep) {
  auto samples = SamplesOf(kPlane, 20, 0.0F);
  for (std::size_t i = 0; i < samples.size(); i += 5) samples[i].disparity += 6.0F;
  const DisparityPlane plain = MomentsOf(samples).Fit();
  const DisparityPlane robust = RefitHuber(samples.data(), samples.size(), plain, 0.5, 10);
  EXPECT_GT(plain.At(10, 10) - kPlane.At(10, 10), 1.0);
  EXPECT_LT(robust.At(10, 10) - kPlane.At(10, 10), 0.2);
}

}  // namespace
}  // namespace stereo_sgmp
