// Sweeps of all paths in 8 bits: the usual ones.

// With the byte shuffles of newer processors, for one step of the disparities.
#ifndef HWY_WANT_AVX3_DL
#define HWY_WANT_AVX3_DL
#endif

#include "aggregation/sweep_kernel.h"

#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "aggregation/sweep_kernel.cc"
#include <hwy/foreach_target.h>
#include <hwy/highway.h>

#include "aggregation/sweep_kernel-inl.h"

HWY_BEFORE_NAMESPACE();
namespace stereo_sgmp {
namespace HWY_NAMESPACE {

void SweepBytes(const SweepStretch<std::uint8_t>& s) { SweepOf<std::uint8_t, kPathsPerSweep>(s); }

}  // namespace HWY_NAMESPACE
}  // namespace stereo_sgmp
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace stereo_sgmp {

HWY_EXPORT(SweepBytes);

void SweepPixels(const SweepStretch<std::uint8_t>& stretch) {
  if (stretch.paths != kPathsPerSweep) return SweepAxisPixels(stretch);
  HWY_DYNAMIC_DISPATCH(SweepBytes)(stretch);
}

}  // namespace stereo_sgmp
#endif  // HWY_ONCE
