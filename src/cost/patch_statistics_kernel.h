#ifndef STEREO_SGMP_COST_PATCH_STATISTICS_KERNEL_H_
#define STEREO_SGMP_COST_PATCH_STATISTICS_KERNEL_H_

#include <array>
#include <cstdint>

namespace stereo_sgmp {

// PatchStatistics of a row of `width` patches, of which those of a last whole vector beyond are
// written too. `pairs` are PatchStatistics::Pairs of the rows y - 2, y and y + 2.
void SumPatches(const std::array<const std::int32_t*, 3>& pairs, int width, std::int32_t* sums,
                float* deviations);

}  // namespace stereo_sgmp

#endif  // STEREO_SGMP_COST_PATCH_STATISTICS_KERNEL_H_
