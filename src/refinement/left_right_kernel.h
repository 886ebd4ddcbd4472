#ifndef STEREO_SGMP_REFINEMENT_LEFT_RIGHT_KERNEL_H_
#define STEREO_SGMP_REFINEMENT_LEFT_RIGHT_KERNEL_H_

#include <cstdint>

#include "aggregation/winner_map.h"

namespace stereo_sgmp {

// LeftRightDifferences of row y.
void LeftRightDifferencesRow(const WinnerMap& map, int y, std::uint16_t* out);

}  // namespace stereo_sgmp

#endif  // STEREO_SGMP_REFINEMENT_LEFT_RIGHT_KERNEL_H_
