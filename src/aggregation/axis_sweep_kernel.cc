// Sweeps of the paths along the axes in 8 bits.

// With the byte shuffles of newer processors, for one step of the disparities.
#ifndef HWY_WANT_AVX3_DL
#define HWY_WANT_AVX3_DL
#endif

#include "aggregation/sweep_kernel.h"

#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "aggregation/axis_sweep_kernel.cc"
#include <hwy/foreach_target.h>
#include <hwy/highway.h>

#include "aggregation/sweep_kernel-inl.h"

HWY_BEFORE_NAMESPACE();
namespace stereo_sgmp {
namespace HWY_NAMESPACE {

void SweepAxisBytes(const SweepStretch<std::uint8_t>& s) { SweepOf<std::uint8_t, 2>(s); }

}  // namespace HWY_NAMESPACE
}  // namespace stereo_sgmp
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace stereo_sgmp {

HWY_EXPORT(SweepAxisBytes);

void SweepAxisPixels(const SweepStretch<std::uint8_t>& stretch) {
  HWY_DYNAMIC_DISPATCH(SweepAxisBytes)(stretch);
}

}  // namespace stereo_sgmp
#endif  // HWY_ONCE
