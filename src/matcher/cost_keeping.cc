#include "matcher/cost_keeping.h"

#include <cstddef>

namespace stereo_sgmp {

bool KeepsCosts(const Options& options, const VolumeShape& shape) {
  constexpr std::size_t kMostKept = std::size_t{384} << 20;  // holds 1440x994x256
  // NCC stores its costs itself.
  return options.cost.kind != CostKind::kNcc && options.memory_limit == 0 &&
         shape.PaddedSize() <= kMostKept;
}

}  // namespace stereo_sgmp
