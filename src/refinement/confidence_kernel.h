// The confidence of a row from its peak differences, for the SIMD target of the machine.
#ifndef STEREO_SGMP_REFINEMENT_CONFIDENCE_KERNEL_H_
#define STEREO_SGMP_REFINEMENT_CONFIDENCE_KERNEL_H_

#include <cstdint>

#include "aggregation/winner_map.h"

namespace stereo_sgmp {

// ConfidenceMeasure::kPeakDifference of row y, with costs that count `weight` times; `left_right`
// is that row of LeftRightDifferences.
void PeakDifferenceRow(const WinnerMap& map, const std::uint16_t* left_right, int y, float weight,
                       float* row);

}  // namespace stereo_sgmp

#endif  // STEREO_SGMP_REFINEMENT_CONFIDENCE_KERNEL_H_
