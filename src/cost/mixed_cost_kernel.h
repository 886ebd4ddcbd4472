#ifndef STEREO_SGMP_COST_MIXED_COST_KERNEL_H_
#define STEREO_SGMP_COST_MIXED_COST_KERNEL_H_

#include <cstdint>

#include "cost/census_transform.h"
#include "cost/cost_rows.h"
#include "cost/feature_planes.h"

namespace stereo_sgmp {

// Planes of the features that MixedCost compares.
struct MixedFeatures {
  static constexpr CensusShape kCensus{3, 2};  // planes [0, kCensus.Bytes())
  static constexpr int kGray = kCensus.Bytes();
  static constexpr int kGradientX = kGray + 1;  // saturated to -128..127, plus 128
  static constexpr int kGradientY = kGray + 2;
  static constexpr int kPlanes = kGray + 3;

  // Half of what each term can reach: 7 * 17 + (17 >> 2) + 15 + 50.
  static constexpr std::uint8_t kOutsideCost = 188;
};

// Differences after[x] - before[x] saturated to -128..127, plus 128.
void SaturatedDifferences(const std::uint8_t* after, const std::uint8_t* before, int width,
                          std::uint8_t* differences);

// Costs of the pixels [x_begin, x_end) of a row, as CostRows::Row lays them out, from the
// features of the left row and of the mirrored right row:
//   min(255, 7 h + floor(h / 4) + min(ad_limit, |dI|) + 10 min(10, |dI_x| + |dI_y|)).
void MixedCostRow(FeatureRow left, FeatureRow right, const VolumeShape& shape,
                  std::uint8_t ad_limit, int x_begin, int x_end, std::uint8_t* costs);

}  // namespace stereo_sgmp

#endif  // STEREO_SGMP_COST_MIXED_COST_KERNEL_H_
