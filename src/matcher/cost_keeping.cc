#include "matcher/cost_keeping.h"

#include <cstddef>

namespace stereo_sgmp {

bool KeepsCosts(const Options& options, const VolumeShape& shape) {
  // Of larger volumes it gains little: at 1280x720x128, three times as large, 2 % of a frame.
  constexpr std::size_t kMostKept = std::size_t{40} << 20;
  return options.cost.kind == CostKind::kMixed && options.memory_limit == 0 &&
         shape.PaddedSize() <= kMostKept;
}

}  // namespace stereo_sgmp
