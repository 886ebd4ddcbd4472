#include "prior/superpixel_kernel.h"

#include <cstddef>
#include <cstdint>
#include <random>
#include <vector>

#include <gtest/gtest.h>
#include <hwy/targets.h>

namespace stereo_sgmp {
namespace {

struct Planes {
  std::vector<float> channel[3];
  std::vector<float> nearest;
  std::vector<std::int32_t> cluster;
};

constexpr int kStride = 90;
constexpr int kRows = 7;

Planes RandomPlanes(unsigned seed) {
  std::mt19937 random(seed);
  std::uniform_int_distribution<int> byte(0, 255);
  Planes planes;
  for (int i = 0; i < kStride * kRows; ++i) {
    for (auto& channel : planes.channel) channel.push_back(static_cast<float>(byte(random)));
    planes.nearest.push_back(static_cast<float>(byte(random) * byte(random)));
    planes.cluster.push_back(-1);
  }
  return planes;
}

ClusterWindow WindowOf(int channels, int width, Planes* planes) {
  ClusterWindow window{};
  const std::size_t corner = 2 * kStride + 5;
  window.channels = channels;
  for (int c = 0; c < channels; ++c) window.channel[c] = planes->channel[c].data() + corner;
  window.nearest = planes->nearest.data() + corner;
  window.cluster = planes->cluster.data() + corner;
  window.stride = kStride;
  window.x = 105;
  window.y = 52;
  window.width = width;
  window.height = 4;
  return window;
}

void AssignScalar(const ClusterWindow& w, const ClusterCentre& centre, float weight,
                  std::int32_t label) {
  for (int y = 0; y < w.height; ++y) {
    for (int x = 0; x < w.width; ++x) {
      const std::ptrdiff_t i = y * w.stride + x;
      const float dx = static_cast<float>(w.x + x) - centre.x;
      const float dy = static_cast<float>(w.y + y) - centre.y;
      float distance = weight * (dx * dx) + weight * (dy * dy);
      for (int c = 0; c < w.channels; ++c) {
        const float difference = w.channel[c][i] - centre.channel[c];
        distance += difference * difference;
      }
      if (distance >= w.nearest[i]) continue;
      w.nearest[i] = distance;
      w.cluster[i] = label;
    }
  }
}

// Whole numbers and halves, weight a power of two: every sum is exact in any order.
TEST(SuperpixelKernel, EqualsScalarOnEveryTargetAndWidth) {
  const ClusterCentre centre{{100.5F, 128.0F, 60.0F}, 120.5F, 53.0F};
  const std::int64_t supported = hwy::SupportedTargets();
  for (std::int64_t rest = supported; rest != 0; rest &= rest - 1) {
    hwy::SetSupportedTargetsForTest(rest & -rest);
    for (const int channels : {1, 3}) {
      for (int width = 1; width < 70; ++width) {
        Planes expected = RandomPlanes(static_cast<unsigned>(width));
        Planes actual = expected;
        AssignScalar(WindowOf(channels, width, &expected), centre, 0.25F, 9);
        AssignWindow(WindowOf(channels, width, &actual), centre, 0.25F, 9);
        ASSERT_EQ(actual.cluster, expected.cluster) << "width " << width;
        ASSERT_EQ(actual.nearest, expected.nearest) << "width " << width;
      }
    }
  }
  hwy::SetSupportedTargetsForTest(0);
}

}  // namespace
}  // namespace stereo_sgmp
