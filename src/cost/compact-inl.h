// Division of costs by the unit of compact costs, for every SIMD target.
#if defined(STEREO_SGMP_COST_COMPACT_INL_H_) == defined(HWY_TARGET_TOGGLE)
#ifdef STEREO_SGMP_COST_COMPACT_INL_H_
#undef STEREO_SGMP_COST_COMPACT_INL_H_
#else
#define STEREO_SGMP_COST_COMPACT_INL_H_
#endif

#include <cstdint>

#include <hwy/highway.h>

#include "cost/cost_unit.h"

HWY_BEFORE_NAMESPACE();
namespace stereo_sgmp {
namespace HWY_NAMESPACE {

// CompactCost(cost, unit) of each byte, for a unit of at least 2.
//
// round(cost r / 2^15) with r = ceil(2^15 / unit) is that: r is at most 1 - 1 / unit too large,
// which moves cost / unit up by less than 255 / 2^15, less than the 1 / (2 unit) or more that
// costs below a tie are away from it.
template <class D>
class CostDivider {
  using V = hwy::HWY_NAMESPACE::Vec<D>;

 public:
#if HWY_TARGET == HWY_SCALAR
  explicit CostDivider(int unit) : unit_(unit) {}
  HWY_INLINE V operator()(V costs) const {
    namespace hn = hwy::HWY_NAMESPACE;
    return hn::Set(D(), CompactCost(hn::GetLane(costs), unit_));
  }

 private:
  int unit_;
#else
  explicit CostDivider(int unit)
      : reciprocal_(hwy::HWY_NAMESPACE::Set(
            D16(), static_cast<std::int16_t>(((1 << 15) + unit - 1) / unit))) {}

  HWY_INLINE V operator()(V costs) const {
    namespace hn = hwy::HWY_NAMESPACE;
    const D d;
    const D16 d16;
    const hn::RebindToUnsigned<D16> du16;
    const auto pairs = hn::BitCast(du16, costs);
    const auto even = hn::And(pairs, hn::Set(du16, std::uint16_t{0xFF}));
    const auto odd = hn::ShiftRight<8>(pairs);
    const auto low = hn::MulFixedPoint15(hn::BitCast(d16, even), reciprocal_);
    const auto high = hn::MulFixedPoint15(hn::BitCast(d16, odd), reciprocal_);
    return hn::BitCast(d, hn::Or(low, hn::ShiftLeft<8>(high)));
  }

 private:
  using D16 = hwy::HWY_NAMESPACE::Repartition<std::int16_t, D>;
  hwy::HWY_NAMESPACE::Vec<D16> reciprocal_;
#endif
};

}  // namespace HWY_NAMESPACE
}  // namespace stereo_sgmp
HWY_AFTER_NAMESPACE();

#endif  // STEREO_SGMP_COST_COMPACT_INL_H_
