#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "refinement/subpixel_kernel.cc"
#include <hwy/foreach_target.h>  // must come before highway.h

#include <hwy/highway.h>

#include "aggregation/winner_map.h"
#include "refinement/subpixel_kernel.h"

HWY_BEFORE_NAMESPACE();
namespace stereo_sgmp {
namespace HWY_NAMESPACE {
namespace hn = hwy::HWY_NAMESPACE;

// Offsets from the rises left = S- - S0 and right = S+ - S0, whole numbers >= 0. A denominator
// that is not 0 is hence at least 2, and the maximum with 1 stands for "0 where it is 0".

struct NoOffset {
  template <class D, class V>
  HWY_INLINE V operator()(D d, V /*left*/, V /*right*/) const {
    return hn::Zero(d);
  }
};

struct EquiangularOffset {
  template <class D, class V>
  HWY_INLINE V operator()(D d, V left, V right) const {
    const V larger = hn::Max(left, right);
    return hn::Div(hn::Sub(left, right), hn::Max(hn::Set(d, 1.0F), hn::Add(larger, larger)));
  }
};

struct ParabolaOffset {
  template <class D, class V>
  HWY_INLINE V operator()(D d, V left, V right) const {
    const V sum = hn::Add(left, right);
    return hn::Div(hn::Sub(left, right), hn::Max(hn::Set(d, 1.0F), hn::Add(sum, sum)));
  }
};

struct BlendOffset {
  template <class D, class V>
  HWY_INLINE V operator()(D d, V left, V right) const {
    const V sum = hn::Add(EquiangularOffset()(d, left, right), ParabolaOffset()(d, left, right));
    return hn::Mul(hn::Set(d, 0.5F), sum);
  }
};

template <class D>
HWY_INLINE hn::Vec<D> LoadFloats(D d, const std::uint16_t* values) {
  const hn::RebindToSigned<D> di;
  return hn::ConvertTo(d, hn::PromoteTo(di, hn::LoadU(hn::Rebind<std::uint16_t, D>(), values)));
}

template <class Offset, class D>
HWY_INLINE void RefineVector(D d, const WinnerRow& row, float min_disparity, int x, float* out) {
  using V = hn::Vec<D>;
  const V none = hn::Set(d, static_cast<float>(WinnerMap::kNone));
  const V cost = LoadFloats(d, row.cost + x);
  const V below = LoadFloats(d, row.below + x);
  const V above = LoadFloats(d, row.above + x);
  const V offset = Offset()(d, hn::Sub(below, cost), hn::Sub(above, cost));
  const auto at_end = hn::Or(hn::Eq(below, none), hn::Eq(above, none));
  const V whole = hn::Add(hn::Set(d, min_disparity), LoadFloats(d, row.winner + x));
  hn::StoreU(hn::Add(whole, hn::IfThenZeroElse(at_end, offset)), d, out + x);
}

template <class Offset>
void RefineRow(const WinnerRow& row, float min_disparity, float* out) {
  const hn::ScalableTag<float> d;
  const int lanes = static_cast<int>(hn::Lanes(d));
  if (row.width < lanes) {
    const hn::CappedTag<float, 1> one;
    for (int x = 0; x < row.width; ++x) RefineVector<Offset>(one, row, min_disparity, x, out);
    return;
  }
  // The last vector overlaps the one before.
  for (int x = 0; x < row.width; x += lanes) {
    RefineVector<Offset>(d, row, min_disparity, HWY_MIN(x, row.width - lanes), out);
  }
}

void RefineSubpixelRowOnTarget(const WinnerRow& row, Subpixel method, float min_disparity,
                               float* out) {
  switch (method) {
    case Subpixel::kEquiangular:
      return RefineRow<EquiangularOffset>(row, min_disparity, out);
    case Subpixel::kParabola:
      return RefineRow<ParabolaOffset>(row, min_disparity, out);
    case Subpixel::kBlend:
      return RefineRow<BlendOffset>(row, min_disparity, out);
    case Subpixel::kNone:
      return RefineRow<NoOffset>(row, min_disparity, out);
  }
}

}  // namespace HWY_NAMESPACE
}  // namespace stereo_sgmp
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace stereo_sgmp {

HWY_EXPORT(RefineSubpixelRowOnTarget);

void RefineSubpixelRow(const WinnerRow& row, Subpixel method, float min_disparity, float* out) {
  HWY_DYNAMIC_DISPATCH(RefineSubpixelRowOnTarget)(row, method, min_disparity, out);
}

}  // namespace stereo_sgmp
#endif  // HWY_ONCE
