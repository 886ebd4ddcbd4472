#include "cost/patch_statistics_kernel.h"

#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "cost/patch_statistics_kernel.cc"
#include <hwy/foreach_target.h>

#include <hwy/highway.h>

#include "cost/pair_dot-inl.h"
#include "cost/patch_statistics.h"

HWY_BEFORE_NAMESPACE();
namespace stereo_sgmp {
namespace HWY_NAMESPACE {
namespace hn = hwy::HWY_NAMESPACE;

void SumPatchesOnTarget(const std::array<const std::int32_t*, 3>& pairs, int width,
                        std::int32_t* sums, float* deviations) {
  const hn::CappedTag<std::int32_t, 16> d32;
  const hn::RebindToFloat<decltype(d32)> df;
  const auto low_half = hn::Set(d32, 0xFFFF);
  const auto pixels = hn::Set(d32, kPatchPixels);
  for (int x = 0; x < width; x += static_cast<int>(hn::Lanes(d32))) {
    // In each half, whose 16 bits are enough for 15 pixels and for all 25.
    auto halves = hn::Zero(d32);
    auto squares = hn::Zero(d32);
    for (int dx = -kPatchRadius; dx <= kPatchRadius; ++dx) {
      const auto first = hn::LoadU(d32, pairs[0] + x + dx);
      const auto second = hn::LoadU(d32, pairs[1] + x + dx);
      const auto last = hn::And(hn::LoadU(d32, pairs[2] + x + dx), low_half);
      halves = hn::Add(halves, hn::Add(hn::Add(first, second), last));
      squares = PairDot(d32, first, first, squares);
      squares = PairDot(d32, second, second, squares);
      squares = PairDot(d32, last, last, squares);
    }
    const auto sum = hn::Add(hn::And(halves, low_half), hn::ShiftRight<16>(halves));
    hn::StoreU(sum, d32, sums + x);
    const auto variance = hn::Sub(hn::Mul(pixels, squares), hn::Mul(sum, sum));
    hn::StoreU(hn::Sqrt(hn::ConvertTo(df, variance)), df, deviations + x);
  }
}

}  // namespace HWY_NAMESPACE
}  // namespace stereo_sgmp
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace stereo_sgmp {

HWY_EXPORT(SumPatchesOnTarget);

void SumPatches(const std::array<const std::int32_t*, 3>& pairs, int width, std::int32_t* sums,
                float* deviations) {
  HWY_DYNAMIC_DISPATCH(SumPatchesOnTarget)(pairs, width, sums, deviations);
}

}  // namespace stereo_sgmp
#endif  // HWY_ONCE
