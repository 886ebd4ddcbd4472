// Counting the bits of bytes is one instruction from this target on.
#ifndef HWY_WANT_AVX3_DL
#define HWY_WANT_AVX3_DL
#endif

#include "cost/census_cost_kernel.h"

#include "cost/match_span.h"

#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "cost/census_cost_kernel.cc"
#include <hwy/foreach_target.h>
#include <hwy/highway.h>

#include "cost/compact-inl.h"
#include "cost/cost_stretch-inl.h"
#include "cost/hamming-inl.h"

HWY_BEFORE_NAMESPACE();
namespace stereo_sgmp {
namespace HWY_NAMESPACE {
namespace hn = hwy::HWY_NAMESPACE;

using D8 = hn::CappedTag<std::uint8_t, VolumeShape::kPadding>;
using V8 = hn::Vec<D8>;

// kScale h, for the scales in use; bytes have no multiplication.
template <int kScale>
HWY_INLINE V8 Scaled(V8 h) {
  static_assert(kScale == 4 || kScale == 10);
  const V8 h2 = hn::Add(h, h);
  const V8 h4 = hn::Add(h2, h2);
  return kScale == 4 ? h4 : hn::Add(hn::Add(h4, h4), h2);
}

// Costs of single left pixels.
template <int kBits, int kScale, bool kCompact>
class CensusPixel {
 public:
  HWY_INLINE CensusPixel(FeatureRow left, FeatureRow right, const VolumeShape& shape, int unit)
      : left_(left), right_(right), first_match_(MirroredColumn(shape, 0)), divide_(unit) {}

  // At the disparity indices `inside`, rounded out to whole vectors.
  HWY_INLINE void operator()(int x, MatchSpan inside, std::uint8_t* costs) const {
    constexpr int kPlanes = (kBits + 7) / 8;
    const D8 d;
    const int lanes = static_cast<int>(hn::Lanes(d));
    // Read before costs are stored, which could change them for all the compiler knows.
    V8 census[kPlanes];
    for (int i = 0; i < kPlanes; ++i) {
      census[i] = hn::Set(d, left_.first[i * left_.distance + x]);
    }
    const std::uint8_t* matches = right_.first + (first_match_ - x);
    for (int k = inside.begin & -lanes; k < inside.end; k += lanes) {
      const V8 h = HammingDistance(d, census, matches + k, right_.distance);
      const V8 full = Scaled<kScale>(h);
      hn::Store(kCompact ? divide_(full) : full, d, costs + k);
    }
  }

 private:
  const FeatureRow left_;
  const FeatureRow right_;
  const std::ptrdiff_t first_match_;
  const CostDivider<D8> divide_;
};

template <int kBits, int kScale, bool kCompact>
HWY_INLINE void CensusStretch(FeatureRow left, FeatureRow right, const VolumeShape& shape, int unit,
                              int x_begin, int x_end, std::uint8_t* costs) {
  const CensusPixel<kBits, kScale, kCompact> pixel(left, right, shape, unit);
  ComputeStretch(shape, x_begin, x_end, CompactCost(kBits * kScale / 2, unit), pixel, costs);
}

template <int kBits, int kScale>
void CensusStretchOfUnit(FeatureRow left, FeatureRow right, const VolumeShape& shape, int unit,
                         int x_begin, int x_end, std::uint8_t* costs) {
  if (unit == 1) {
    CensusStretch<kBits, kScale, false>(left, right, shape, unit, x_begin, x_end, costs);
  } else {
    CensusStretch<kBits, kScale, true>(left, right, shape, unit, x_begin, x_end, costs);
  }
}

void Census5x5Stretch(FeatureRow left, FeatureRow right, const VolumeShape& shape, int unit,
                      int x_begin, int x_end, std::uint8_t* costs) {
  CensusStretchOfUnit<kCensus5x5.Bits(), 10>(left, right, shape, unit, x_begin, x_end, costs);
}

void Census9x7Stretch(FeatureRow left, FeatureRow right, const VolumeShape& shape, int unit,
                      int x_begin, int x_end, std::uint8_t* costs) {
  CensusStretchOfUnit<kCensus9x7.Bits(), 4>(left, right, shape, unit, x_begin, x_end, costs);
}

}  // namespace HWY_NAMESPACE
}  // namespace stereo_sgmp
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace stereo_sgmp {

HWY_EXPORT(Census5x5Stretch);
HWY_EXPORT(Census9x7Stretch);

void Census5x5CostRow(FeatureRow left, FeatureRow right, const VolumeShape& shape, int unit,
                      int x_begin, int x_end, std::uint8_t* costs) {
  HWY_DYNAMIC_DISPATCH(Census5x5Stretch)(left, right, shape, unit, x_begin, x_end, costs);
}

void Census9x7CostRow(FeatureRow left, FeatureRow right, const VolumeShape& shape, int unit,
                      int x_begin, int x_end, std::uint8_t* costs) {
  HWY_DYNAMIC_DISPATCH(Census9x7Stretch)(left, right, shape, unit, x_begin, x_end, costs);
}

}  // namespace stereo_sgmp
#endif  // HWY_ONCE
