#ifndef STEREO_SGMP_REFINEMENT_SUBPIXEL_KERNEL_H_
#define STEREO_SGMP_REFINEMENT_SUBPIXEL_KERNEL_H_

#include <cstdint>

#include "stereo_sgmp/options.h"

namespace stereo_sgmp {

// The winners of a row of `width` pixels and the costs at them and beside.
struct WinnerRow {
  const std::uint16_t* winner;
  const std::uint16_t* cost;
  const std::uint16_t* below;  // WinnerMap::kNone where there is none, as in `above`
  const std::uint16_t* above;
  int width;
};

// RefineSubpixel of a row.
void RefineSubpixelRow(const WinnerRow& row, Subpixel method, float min_disparity, float* out);

}  // namespace stereo_sgmp

#endif  // STEREO_SGMP_REFINEMENT_SUBPIXEL_KERNEL_H_
