#include "common/simd_target.h"

#include <hwy/highway.h>

namespace stereo_sgmp {

const char* SimdTargetName() {
  // Better targets have lower bits.
  const auto usable = hwy::SupportedTargets() & HWY_TARGETS;
  return hwy::TargetName(usable & -usable);
}

}  // namespace stereo_sgmp
