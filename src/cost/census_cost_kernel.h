#ifndef STEREO_SGMP_COST_CENSUS_COST_KERNEL_H_
#define STEREO_SGMP_COST_CENSUS_COST_KERNEL_H_

#include <cstdint>

#include "cost/census_transform.h"
#include "cost/cost_rows.h"
#include "cost/feature_planes.h"

namespace stereo_sgmp {

inline constexpr CensusShape kCensus5x5{2, 2};
inline constexpr CensusShape kCensus9x7{4, 3};

// Costs of the pixels [x_begin, x_end) of a row, as CostRows::Row lays them out, from the census
// bits of the left row and of the mirrored right row: the CompactCost of 10 h for 5x5 and of 4 h
// for 9x7.
void Census5x5CostRow(FeatureRow left, FeatureRow right, const VolumeShape& shape, int unit,
                      int x_begin, int x_end, std::uint8_t* costs);
void Census9x7CostRow(FeatureRow left, FeatureRow right, const VolumeShape& shape, int unit,
                      int x_begin, int x_end, std::uint8_t* costs);

}  // namespace stereo_sgmp

#endif  // STEREO_SGMP_COST_CENSUS_COST_KERNEL_H_
