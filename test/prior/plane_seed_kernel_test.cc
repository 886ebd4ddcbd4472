#include "prior/plane_seed_kernel.h"

#include <gtest/gtest.h>
#include <hwy/targets.h>

#include <cmath>
#include <cstddef>
#include <limits>
#include <random>
#include <vector>

#include "prior/plane_fit.h"

namespace stereo_sgmp {
namespace {

constexpr int kStride = 2 * kSeedOverrun;
constexpr int kHeight = 2 * kSeedRadius + 1;
constexpr float kNone = std::numeric_limits<float>::quiet_NaN();

struct Seed {
  double rank = std::numeric_limits<double>::infinity();
  DisparityPlane plane;
};

PlaneMoments ReferenceMoments(const float* centre) {
  PlaneMoments moments;
  for (int dy = -kSeedRadius; dy <= kSeedRadius; ++dy) {
    for (int dx = -kSeedRadius; dx <= kSeedRadius; ++dx) {
      const float difference = centre[dy * kStride + dx] - *centre;
      if (std::abs(difference) < 2.0F) moments.Add(dx, dy, difference);
    }
  }
  return moments;
}

Seed ReferenceSeed(const float* centre) {
  Seed seed;
  const PlaneMoments moments = ReferenceMoments(centre);
  const double fill = moments.weight() / (kHeight * kHeight);
  if (std::isnan(*centre) || fill < 0.6) return seed;
  seed.plane = moments.Fit();
  seed.rank = moments.Rms(seed.plane) + 0.1 * (1.0 - fill);
  return seed;
}

// A slanted plane with noise, a step, and pixels missing. In eighths: sums are exact in any order.
std::vector<float> RandomRows(unsigned seed) {
  std::mt19937 random(seed);
  std::normal_distribution<float> noise(0.0F, 0.3F);
  std::vector<float> rows(static_cast<std::size_t>(kStride * kHeight));
  for (std::size_t i = 0; i < rows.size(); ++i) {
    const std::size_t row = i / kStride;
    const auto x = static_cast<float>(i % kStride);
    const auto y = static_cast<float>(row);
    rows[i] = random() % 8 == 0 ? kNone : 0.2F * x - 0.1F * y + noise(random);
    rows[i] = std::round(8.0F * rows[i]) / 8.0F;
    if (x > 40.0F) rows[i] += 9.0F;
    if (x > 55.0F && random() % 2 == 0) rows[i] = kNone;
  }
  return rows;
}

TEST(PlaneSeedKernel, EqualsPlaneMomentsOnEveryTarget) {
  int found = 0;
  for (unsigned round = 0; round < 20; ++round) {
    const std::vector<float> rows = RandomRows(round);
    const float* const centre = rows.data() + kSeedRadius * kStride + kSeedRadius;
    for (const auto target : hwy::SupportedAndGeneratedTargets()) {
      hwy::SetSupportedTargetsForTest(target);
      SeedBatch batch;
      FitSeeds(centre, kStride, &batch);
      hwy::SetSupportedTargetsForTest(0);
      for (std::size_t i = 0; i < kSeedBatch; ++i) {
        const Seed expected = ReferenceSeed(centre + kSeedStep * i);
        ASSERT_EQ(batch.rank[i], expected.rank) << hwy::TargetName(target) << " " << i;
        if (std::isinf(expected.rank)) continue;
        ++found;
        ASSERT_EQ(batch.a[i], expected.plane.a) << hwy::TargetName(target) << " " << i;
        ASSERT_EQ(batch.b[i], expected.plane.b) << hwy::TargetName(target) << " " << i;
        ASSERT_EQ(batch.c[i], expected.plane.c) << hwy::TargetName(target) << " " << i;
      }
    }
  }
  EXPECT_GT(found, 100);
}

}  // namespace
}  // namespace stereo_sgmp
