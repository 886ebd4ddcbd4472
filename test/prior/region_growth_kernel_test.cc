#include "prior/region_growth_kernel.h"

#include <gtest/gtest.h>
#include <hwy/targets.h>

#include <cmath>
#include <cstddef>
#include <cstdint>
#include <random>
#include <vector>

namespace stereo_sgmp {
namespace {

constexpr int kWidth = 37;
constexpr int kHeight = 23;
constexpr int kStride = kWidth + 2 * kGapOverrun;
constexpr std::size_t kOrigin = kGap * kStride + kGap;
constexpr std::size_t kPadded = kStride * (kHeight + 2 * kGap);

// An image whose disparities are near a plane in parts, and a region in it.
struct Image {
  explicit Image(unsigned seed)
      : disparity(kPadded, std::numeric_limits<float>::quiet_NaN()),
        reached(kPadded, 0),
        pixels(kWidth * kHeight) {
    std::mt19937 random(seed);
    std::uniform_real_distribution<float> noise(-1.0F, 1.0F);
    for (int y = 0; y < kHeight; ++y) {
      for (int x = 0; x < kWidth; ++x) {
        if (random() % 5 == 0) continue;
        disparity[kOrigin + static_cast<std::size_t>(y * kStride + x)] =
            static_cast<float>(plane.At(x, y)) + noise(random) * (x < 20 ? 0.7F : 1.0F);
      }
    }
  }
  Region Start() {
    Region region{&disparity[kOrigin], &reached[kOrigin], kStride, pixels.data(), 0};
    TakePixel(kWidth / 2, kHeight / 2, &region);
    return region;
  }

  DisparityPlane plane{0.31, -0.17, 20.3};
  std::vector<float> disparity;
  std::vector<std::uint8_t> reached;
  std::vector<DisparitySample> pixels;
};

std::size_t ReferenceGrow(const DisparityPlane& plane, std::size_t next, double most,
                          Region* region) {
  const float slope = static_cast<float>(plane.a);
  while (next < region->count && static_cast<double>(region->count) <= most) {
    const DisparitySample from = region->pixels[next++];
    for (int dy = -kGap; dy <= kGap; ++dy) {
      const int y = static_cast<int>(from.y) + dy;
      const float centre = static_cast<float>(plane.At(from.x, y));
      for (int dx = -kGap; dx <= kGap; ++dx) {
        const int x = static_cast<int>(from.x) + dx;
        const float residual =
            region->disparity[y * kStride + x] - (centre + slope * static_cast<float>(dx));
        if (std::abs(residual) < kGrowRange) TakePixel(x, y, region);
      }
    }
  }
  return next;
}

TEST(RegionGrowthKernel, TakesWhatTheDefinitionDoesInItsOrderOnEveryTarget) {
  for (unsigned round = 0; round < 10; ++round) {
    for (const double most : {5.0, 150.0, 1e9}) {
      Image expected(round);
      Region expected_region = expected.Start();
      const std::size_t expected_next = ReferenceGrow(expected.plane, 0, most, &expected_region);
      for (const auto target : hwy::SupportedAndGeneratedTargets()) {
        hwy::SetSupportedTargetsForTest(target);
        Image actual(round);
        Region region = actual.Start();
        const std::size_t next = GrowRegion(actual.plane, 0, most, &region);
        hwy::SetSupportedTargetsForTest(0);
        ASSERT_EQ(next, expected_next) << hwy::TargetName(target);
        ASSERT_EQ(region.count, expected_region.count) << hwy::TargetName(target);
        ASSERT_EQ(actual.reached, expected.reached);
        for (std::size_t i = 0; i < region.count; ++i) {
          ASSERT_EQ(region.pixels[i].x, expected_region.pixels[i].x) << i;
          ASSERT_EQ(region.pixels[i].y, expected_region.pixels[i].y) << i;
          ASSERT_EQ(region.pixels[i].disparity, expected_region.pixels[i].disparity) << i;
        }
      }
    }
  }
}

}  // namespace
}  // namespace stereo_sgmp
