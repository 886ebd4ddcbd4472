// The pixels of a stretch of a row of costs, for every SIMD target.
#if defined(STEREO_SGMP_COST_COST_STRETCH_INL_H_) == defined(HWY_TARGET_TOGGLE)
#ifdef STEREO_SGMP_COST_COST_STRETCH_INL_H_
#undef STEREO_SGMP_COST_COST_STRETCH_INL_H_
#else
#define STEREO_SGMP_COST_COST_STRETCH_INL_H_
#endif

#include <cstdint>

#include <hwy/highway.h>

#include "cost/match_span.h"

HWY_BEFORE_NAMESPACE();
namespace stereo_sgmp {
namespace HWY_NAMESPACE {

// The costs of the pixels [x_begin, x_end) of a row, as CostRows::Row lays them out:
// pixel(x, inside, costs) sets those of one at the disparity indices `inside`, rounded out to whole
// vectors; `outside_cost` is that of the others, which most pixels don't have.
template <class Pixel>
HWY_INLINE void ComputeStretch(const VolumeShape& shape, int x_begin, int x_end,
                               std::uint8_t outside_cost, const Pixel& pixel, std::uint8_t* costs) {
  const int stride = shape.Stride();
  const MatchSpan all{0, shape.disparities};
  const MatchSpan inner = InnerColumns(shape);
  for (int x = x_begin; x < x_end;) {
    if (HWY_LIKELY(x >= inner.begin && x < inner.end)) {
      for (const int end = HWY_MIN(x_end, inner.end); x < end; ++x, costs += stride) {
        pixel(x, all, costs);
      }
      continue;
    }
    const int end = x < inner.begin ? HWY_MIN(x_end, inner.begin) : x_end;
    for (; x < end; ++x, costs += stride) {
      const MatchSpan inside = InsideSpan(shape, x);
      pixel(x, inside, costs);
      FillOutside(shape, inside, outside_cost, costs);
    }
  }
}

}  // namespace HWY_NAMESPACE
}  // namespace stereo_sgmp
HWY_AFTER_NAMESPACE();

#endif  // STEREO_SGMP_COST_COST_STRETCH_INL_H_
