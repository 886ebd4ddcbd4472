#ifndef STEREO_SGMP_COST_COMPACT_KERNEL_H_
#define STEREO_SGMP_COST_COMPACT_KERNEL_H_

#include <cstddef>
#include <cstdint>

namespace stereo_sgmp {

// Replaces full costs by their CompactCost. `costs` is aligned to 64, and `count` a multiple of 64.
void CompactCosts(int unit, std::size_t count, std::uint8_t* costs);

}  // namespace stereo_sgmp

#endif  // STEREO_SGMP_COST_COMPACT_KERNEL_H_
