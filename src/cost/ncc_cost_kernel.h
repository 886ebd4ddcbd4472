#ifndef STEREO_SGMP_COST_NCC_COST_KERNEL_H_
#define STEREO_SGMP_COST_NCC_COST_KERNEL_H_

#include <cstdint>

#include "cost/cost_rows.h"
#include "cost/patch_statistics.h"

namespace stereo_sgmp {

// A row of left patches and the rows of (mirrored) right patches that they are compared with:
// row right_first and the right_count - 1 rows below it.
struct NccRows {
  static constexpr int kMaxRightCount = 3;

  const PatchStatistics* left = nullptr;
  const PatchStatistics* right = nullptr;
  int left_y = 0;
  int right_first = 0;
  int right_count = 1;
};

inline constexpr std::uint8_t kNccOutsideCost = 255;

// round(255 (1 - max(0, NCC))) with the largest NCC of the right rows, for all pixels of the left
// row, as CostRows::Row lays them out.
void NccCostRow(const NccRows& rows, const VolumeShape& shape, float epsilon, std::uint8_t* costs);

}  // namespace stereo_sgmp

#endif  // STEREO_SGMP_COST_NCC_COST_KERNEL_H_
