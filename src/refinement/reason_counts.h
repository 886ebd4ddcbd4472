#ifndef STEREO_SGMP_REFINEMENT_REASON_COUNTS_H_
#define STEREO_SGMP_REFINEMENT_REASON_COUNTS_H_

#include <array>
#include <cstdint>

#include "stereo_sgmp/match_result.h"

namespace stereo_sgmp {

using ReasonCounts = std::array<int, kInvalidReasonCount>;

// Adds the pixels of each InvalidReason in a row to `counts`.
void CountReasonsInRow(const std::uint8_t* reasons, int width, ReasonCounts* counts);

}  // namespace stereo_sgmp

#endif  // STEREO_SGMP_REFINEMENT_REASON_COUNTS_H_
