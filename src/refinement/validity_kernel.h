#ifndef STEREO_SGMP_REFINEMENT_VALIDITY_KERNEL_H_
#define STEREO_SGMP_REFINEMENT_VALIDITY_KERNEL_H_

#include <cstdint>

#include "aggregation/winner_map.h"
#include "stereo_sgmp/options.h"

namespace stereo_sgmp {

// What FindInvalid looks at in a row beside the winners.
struct CheckedRow {
  const std::uint16_t* left_right;
  const float* disparity;
  const float* confidence;
};

// FindInvalid of row y, but for uniqueness.
void FindInvalidRow(const WinnerMap& map, int y, const CheckedRow& row,
                    const FilterOptions& options, std::uint8_t* out);

}  // namespace stereo_sgmp

#endif  // STEREO_SGMP_REFINEMENT_VALIDITY_KERNEL_H_
