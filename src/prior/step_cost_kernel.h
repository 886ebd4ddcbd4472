#ifndef STEREO_SGMP_PRIOR_STEP_COST_KERNEL_H_
#define STEREO_SGMP_PRIOR_STEP_COST_KERNEL_H_

#include <cstdint>

namespace stereo_sgmp {

// What a step of LabelSpreader costs for `count` pairs of pixels: 2 plus the largest difference of
// the first three channels, at most 255. Pixels have 1, 3 or 4 interleaved channels.
void StepCosts(const std::uint8_t* from, const std::uint8_t* to, int channels, int count,
               std::uint8_t* costs);

}  // namespace stereo_sgmp

#endif  // STEREO_SGMP_PRIOR_STEP_COST_KERNEL_H_
