#ifndef STEREO_SGMP_COST_MIXED_COST_KERNEL_H_
#define STEREO_SGMP_COST_MIXED_COST_KERNEL_H_

#include <cstdint>

#include "cost/census_transform.h"
#include "cost/cost_rows.h"
#include "cost/feature_planes.h"

namespace stereo_sgmp {

// Planes of the features that MixedCost compares: census bits, and signed bytes.
struct MixedFeatures {
  static constexpr CensusShape kCensus{3, 2};    // planes [0, kCensus.Bytes())
  static constexpr int kGray = kCensus.Bytes();  // minus 128
  static constexpr int kGradientX = kGray + 1;
  static constexpr int kGradientY = kGray + 2;
  static constexpr int kPlanes = kGray + 3;
};

// How MixedCost adds its terms.
struct FullMixedCost {
  static constexpr int kMax = 255;
  // Half of what each term can reach: 7 * 17 + floor(17 / 4) + 15 + 10 * 5.
  static constexpr std::uint8_t kOutside = 188;
};
struct CompactMixedCost {
  static constexpr int kMax = 36;
  // 17 + 5 + ceil((15 + 3 * 5) / 8).
  static constexpr std::uint8_t kOutside = 26;
};

// Differences after[x] - before[x] as signed bytes, saturated to -128..127.
void SaturatedDifferences(const std::uint8_t* after, const std::uint8_t* before, int width,
                          std::uint8_t* differences);

// Costs of the pixels [x_begin, x_end) of a row, as CostRows::Row lays them out, from the
// features of the left row and of the mirrored right row, by the formulas of MixedCost.
// ad_limit: the largest absolute difference that counts, at most 30.
void FullMixedCostRow(FeatureRow left, FeatureRow right, const VolumeShape& shape,
                      std::uint8_t ad_limit, int x_begin, int x_end, std::uint8_t* costs);
void CompactMixedCostRow(FeatureRow left, FeatureRow right, const VolumeShape& shape,
                         std::uint8_t ad_limit, int x_begin, int x_end, std::uint8_t* costs);

}  // namespace stereo_sgmp

#endif  // STEREO_SGMP_COST_MIXED_COST_KERNEL_H_
