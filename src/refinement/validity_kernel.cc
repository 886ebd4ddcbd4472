#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "refinement/validity_kernel.cc"
#include <hwy/foreach_target.h>  // must come before highway.h

#include <hwy/highway.h>

#include "common/numbers-inl.h"
#include "refinement/right_winners-inl.h"
#include "refinement/validity_kernel.h"
#include "stereo_sgmp/match_result.h"

#ifndef STEREO_SGMP_REFINEMENT_VALIDITY_KERNEL_ONCE
#define STEREO_SGMP_REFINEMENT_VALIDITY_KERNEL_ONCE

#include <algorithm>
#include <cmath>
#include <limits>

namespace stereo_sgmp {
namespace validity {

// Smoothing may mend a winner that is off by this many tolerances. Further off are the winners in
// occlusions, whose filling would agree with the right image's winners for no good reason.
constexpr double kMendable = 2.0;

// A float is smaller than `limit` where it is smaller than this.
inline float SmallestFrom(double limit) {
  const auto nearest = static_cast<float>(limit);
  if (static_cast<double>(nearest) >= limit) return nearest;
  return std::nextafter(nearest, std::numeric_limits<float>::infinity());
}

// The options as they are compared with.
struct Limits {
  Limits(const FilterOptions& options, const VolumeShape& shape)
      : width(shape.width),
        min_disparity(shape.min_disparity),
        // Of two disparities, both are ends.
        last(shape.disparities > 2 ? shape.disparities - 1 : -1),
        first(shape.disparities > 2 ? 0 : -1),
        check_sides(options.lr_tolerance >= 0.0),
        tolerance(options.lr_tolerance),
        mendable(static_cast<int>(std::clamp(std::floor(kMendable * tolerance), -1.0,
                                             static_cast<double>(WinnerMap::kNone)))),
        min_confidence(SmallestFrom(options.min_confidence)) {}

  int width;
  int min_disparity;
  int last;
  int first;
  bool check_sides;
  double tolerance;
  int mendable;
  float min_confidence;
};

}  // namespace validity
}  // namespace stereo_sgmp

#endif  // STEREO_SGMP_REFINEMENT_VALIDITY_KERNEL_ONCE

HWY_BEFORE_NAMESPACE();
namespace stereo_sgmp {
namespace HWY_NAMESPACE {
namespace hn = hwy::HWY_NAMESPACE;

template <class V>
HWY_INLINE hn::Vec<hn::Rebind<std::int32_t, hn::DFromV<V>>> RoundHalfAway(V value) {
  const hn::DFromV<V> d;
  const hn::Rebind<std::int32_t, decltype(d)> di;
  const auto whole = hn::ConvertTo(di, value);
  const auto rest = hn::Sub(value, hn::ConvertTo(d, whole));  // exact
  // A mask is -1.
  const auto up = hn::VecFromMask(di, hn::RebindMask(di, hn::Ge(rest, hn::Set(d, 0.5F))));
  const auto down = hn::VecFromMask(di, hn::RebindMask(di, hn::Le(rest, hn::Set(d, -0.5F))));
  return hn::Add(hn::Sub(whole, up), down);
}

// far[i] = 1 where the disparity of pixel i is further than the tolerance from that of the right
// winner, else 0. In doubles, in which the difference is exact.
template <class D64>
HWY_INLINE void FindFar(D64 d64, const RightWinners& right, const float* disparity, int count,
                        const validity::Limits& limits, float* far) {
  const hn::Rebind<float, D64> d;
  const hn::Rebind<std::int32_t, D64> di;
  const hn::Rebind<std::uint16_t, D64> d16;
  const auto tolerance = hn::Set(d64, limits.tolerance);
  const auto min_disparity = hn::Set(di, limits.min_disparity);
  const int lanes = static_cast<int>(hn::Lanes(d64));
  for (int i = 0; i < count; i += lanes) {
    const auto winner = hn::Add(hn::PromoteTo(di, right.Winners(d16, i)), min_disparity);
    const auto left = hn::PromoteTo(d64, hn::LoadU(d, disparity + i));
    const auto apart = hn::Abs(hn::Sub(hn::PromoteTo(d64, winner), left));
    const auto is_far = hn::IfThenElseZero(hn::Gt(apart, tolerance), hn::Set(d64, 1.0));
    hn::StoreU(hn::DemoteTo(d, is_far), d, far + i);
  }
}

template <class DI>
HWY_INLINE hn::Mask<DI> IsEnd(DI di, hn::Vec<DI> winner, const validity::Limits& limits) {
  return hn::Or(hn::Eq(winner, hn::Set(di, limits.first)),
                hn::Eq(winner, hn::Set(di, limits.last)));
}

template <class DI>
HWY_INLINE hn::Mask<DI> IsOutside(DI di, hn::Vec<DI> column, const validity::Limits& limits) {
  return hn::Or(hn::Lt(column, hn::Zero(di)), hn::Gt(column, hn::Set(di, limits.width - 1)));
}

template <class DI>
HWY_INLINE hn::Vec<DI> Reason(DI di, InvalidReason reason) {
  return hn::Set(di, static_cast<std::int32_t>(reason));
}

// All checks of a pixel are made and the first that applies is chosen: branches would mispredict.
template <class D, class D64>
void FindInvalidInRow(D d, D64 d64, const WinnerMap& map, int y, const CheckedRow& row,
                      const validity::Limits& limits, std::uint8_t* out) {
  const hn::RebindToSigned<D> di;
  const hn::Rebind<std::uint16_t, D> d16;
  const hn::Rebind<std::uint8_t, D> d8;
  const int lanes = static_cast<int>(hn::Lanes(d));
  const std::uint16_t* const winners = map.winner[y];
  const auto sided =
      Reason(di, limits.check_sides ? InvalidReason::kLeftRight : InvalidReason::kValid);
  RightWinners right(map.right_winner[y], limits.width);
  HWY_ALIGN float far[RightWinners::kMost];
  ForStretches(limits.width, lanes, [&](int begin, int count) {
    for (int i = 0; i < count; i += lanes) {
      const auto disparity = RoundHalfAway(hn::LoadU(d, row.disparity + begin + i));
      right.SetMatches(di, i, hn::Sub(NumbersFrom(di, begin + i), disparity));
    }
    right.Read(count);
    FindFar(d64, right, row.disparity + begin, count, limits, far);
    for (int i = 0; i < count; i += lanes) {
      const int x = begin + i;
      const auto right_winner = hn::PromoteTo(di, right.Winners(d16, i));
      const auto left_right = hn::PromoteTo(di, hn::LoadU(d16, row.left_right + x));
      const auto is_far = hn::RebindMask(di, hn::Gt(hn::LoadU(d, far + i), hn::Zero(d)));
      const auto disagree = hn::Or(hn::Or(hn::Eq(right_winner, hn::Set(di, WinnerMap::kNone)),
                                          hn::Gt(left_right, hn::Set(di, limits.mendable))),
                                   is_far);
      auto reason = hn::IfThenElseZero(disagree, sided);
      const auto unsure =
          hn::Lt(hn::LoadU(d, row.confidence + x), hn::Set(d, limits.min_confidence));
      reason = hn::IfThenElse(hn::RebindMask(di, unsure), Reason(di, InvalidReason::kUncertainty),
                              reason);
      const auto winner = hn::PromoteTo(di, hn::LoadU(d16, winners + x));
      const auto match = hn::Sub(NumbersFrom(di, x - limits.min_disparity), winner);
      reason =
          hn::IfThenElse(IsOutside(di, match, limits), Reason(di, InvalidReason::kBorder), reason);
      reason = hn::IfThenElse(IsEnd(di, winner, limits), Reason(di, InvalidReason::kRange), reason);
      hn::StoreU(hn::DemoteTo(d8, reason), d8, out + x);
    }
  });
}

void FindInvalidInRowOnTarget(const WinnerMap& map, int y, const CheckedRow& row,
                              const FilterOptions& options, std::uint8_t* out) {
  const validity::Limits limits(options, map.shape);
  const hn::ScalableTag<float> wide;
  if (limits.width >= static_cast<int>(hn::Lanes(wide))) {
    FindInvalidInRow(wide, hn::ScalableTag<double>(), map, y, row, limits, out);
  } else {
    FindInvalidInRow(hn::CappedTag<float, 1>(), hn::CappedTag<double, 1>(), map, y, row, limits,
                     out);
  }
}

}  // namespace HWY_NAMESPACE
}  // namespace stereo_sgmp
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace stereo_sgmp {

HWY_EXPORT(FindInvalidInRowOnTarget);

void FindInvalidRow(const WinnerMap& map, int y, const CheckedRow& row,
                    const FilterOptions& options, std::uint8_t* out) {
  HWY_DYNAMIC_DISPATCH(FindInvalidInRowOnTarget)(map, y, row, options, out);
}

}  // namespace stereo_sgmp
#endif  // HWY_ONCE
