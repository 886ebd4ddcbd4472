#include "images/pixel_difference_kernel.h"

#include <gtest/gtest.h>
#include <hwy/targets.h>

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <cstdlib>
#include <random>
#include <vector>

namespace stereo_sgmp {
namespace {

TEST(PixelDifferenceKernel, EqualsTheDefinitionOnEveryTargetAndWidth) {
  std::mt19937 random(1);
  for (const int channels : {1, 3, 4}) {
    for (int count = 0; count < 150; ++count) {
      std::vector<std::uint8_t> from(static_cast<std::size_t>(count * channels));
      std::vector<std::uint8_t> to(from.size());
      for (std::uint8_t& value : from) value = static_cast<std::uint8_t>(random());
      for (std::uint8_t& value : to) value = static_cast<std::uint8_t>(random());
      const auto base = static_cast<std::uint8_t>(count % 3);
      std::vector<std::uint8_t> expected(static_cast<std::size_t>(count) + 1, 77);
      for (int x = 0; x < count; ++x) {
        int largest = 0;
        for (int c = 0; c < std::min(channels, 3); ++c) {
          const auto i = static_cast<std::size_t>(x * channels + c);
          largest = std::max(largest, std::abs(from[i] - to[i]));
        }
        expected[static_cast<std::size_t>(x)] =
            static_cast<std::uint8_t>(std::min(largest + base, 255));
      }
      for (const auto target : hwy::SupportedAndGeneratedTargets()) {
        hwy::SetSupportedTargetsForTest(target);
        std::vector<std::uint8_t> differences(expected.size(), 77);
        PixelDifferences(from.data(), to.data(), channels, count, base, differences.data());
        hwy::SetSupportedTargetsForTest(0);
        ASSERT_EQ(differences, expected)
            << hwy::TargetName(target) << " " << channels << " " << count;
      }
    }
  }
}

}  // namespace
}  // namespace stereo_sgmp
