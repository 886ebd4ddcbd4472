#include "prior/region_growth_kernel.h"

#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "prior/region_growth_kernel.cc"
#include <hwy/foreach_target.h>
#include <hwy/highway.h>

HWY_BEFORE_NAMESPACE();
namespace stereo_sgmp {
namespace HWY_NAMESPACE {
namespace hn = hwy::HWY_NAMESPACE;

constexpr int kAround = 2 * kGap + 1;
constexpr int kBitsOfRow = 8;  // of which kAround are used

using Floats = hn::CappedTag<float, kGapOverrun>;

// Which pixels of a row around one are near the plane, a bit each. `centre` is the plane's
// disparity in the middle and `slopes` what is added to it.
HWY_INLINE std::uint64_t NearOfRow(const float* row, float centre, const float* slopes) {
  const Floats d;
  const int lanes = static_cast<int>(hn::Lanes(d));
  std::uint64_t near = 0;
  for (int i = 0; i < kAround; i += lanes) {
    const auto plane = hn::Add(hn::Set(d, centre), hn::Load(d, slopes + i));
    const auto residual = hn::Sub(hn::LoadU(d, row + i), plane);
    std::uint8_t bits[8] = {};
    hn::StoreMaskBits(d, hn::Lt(hn::Abs(residual), hn::Set(d, kGrowRange)), bits);
    near |= static_cast<std::uint64_t>(bits[0] & ((1 << lanes) - 1)) << i;
  }
  return near & ((1U << kAround) - 1);
}

std::size_t GrowOnTarget(const DisparityPlane& plane, std::size_t next, double most,
                         Region* region) {
  const float slope = static_cast<float>(plane.a);
  HWY_ALIGN float slopes[kGapOverrun];
  for (int i = 0; i < kGapOverrun; ++i) slopes[i] = slope * static_cast<float>(i - kGap);
  Region grown = *region;  // in registers
  while (next < grown.count && static_cast<double>(grown.count) <= most) {
    const int x = static_cast<int>(grown.pixels[next].x);
    const int y = static_cast<int>(grown.pixels[next].y);
    ++next;
    const float* row =
        grown.disparity + static_cast<std::ptrdiff_t>(y - kGap) * grown.stride + (x - kGap);
    std::uint64_t near = 0;
    for (int i = 0; i < kAround; ++i, row += grown.stride) {
      const float centre = static_cast<float>(plane.At(x, y - kGap + i));
      near |= NearOfRow(row, centre, slopes) << (kBitsOfRow * i);
    }
    for (; near != 0; near &= near - 1) {
      const int bit = static_cast<int>(hwy::Num0BitsBelowLS1Bit_Nonzero64(near));
      TakePixel(x - kGap + bit % kBitsOfRow, y - kGap + bit / kBitsOfRow, &grown);
    }
  }
  *region = grown;
  return next;
}

}  // namespace HWY_NAMESPACE
}  // namespace stereo_sgmp
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace stereo_sgmp {

HWY_EXPORT(GrowOnTarget);

std::size_t GrowRegion(const DisparityPlane& plane, std::size_t next, double most, Region* region) {
  return HWY_DYNAMIC_DISPATCH(GrowOnTarget)(plane, next, most, region);
}

}  // namespace stereo_sgmp
#endif  // HWY_ONCE
