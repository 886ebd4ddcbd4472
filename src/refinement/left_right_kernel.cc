#include "refinement/left_right_kernel.h"

#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "refinement/left_right_kernel.cc"
#include <hwy/foreach_target.h>
#include <hwy/highway.h>

#include "common/numbers-inl.h"
#include "refinement/right_winners-inl.h"

HWY_BEFORE_NAMESPACE();
namespace stereo_sgmp {
namespace HWY_NAMESPACE {
namespace hn = hwy::HWY_NAMESPACE;

template <class DI>
void DifferencesOfRow(DI di, const WinnerMap& map, int y, std::uint16_t* out) {
  const hn::Rebind<std::uint16_t, DI> d16;
  const int lanes = static_cast<int>(hn::Lanes(di));
  const auto none = hn::Set(d16, WinnerMap::kNone);
  const std::uint16_t* const winners = map.winner[y];
  RightWinners right(map.right_winner[y], map.shape.width);
  ForStretches(map.shape.width, lanes, [&](int x, int count) {
    for (int i = 0; i < count; i += lanes) {
      const auto column = NumbersFrom(di, x + i - map.shape.min_disparity);
      const auto winner = hn::PromoteTo(di, hn::LoadU(d16, winners + x + i));
      right.SetMatches(di, i, hn::Sub(column, winner));
    }
    right.Read(count);
    for (int i = 0; i < count; i += lanes) {
      const auto a = right.Winners(d16, i);
      const auto b = hn::LoadU(d16, winners + x + i);
      const auto difference = hn::Sub(hn::Max(a, b), hn::Min(a, b));
      hn::StoreU(hn::IfThenElse(hn::Eq(a, none), none, difference), d16, out + x + i);
    }
  });
}

void DifferencesOfRowOnTarget(const WinnerMap& map, int y, std::uint16_t* out) {
  const hn::ScalableTag<std::int32_t> wide;
  if (map.shape.width >= static_cast<int>(hn::Lanes(wide))) {
    DifferencesOfRow(wide, map, y, out);
  } else {
    DifferencesOfRow(hn::CappedTag<std::int32_t, 1>(), map, y, out);
  }
}

}  // namespace HWY_NAMESPACE
}  // namespace stereo_sgmp
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace stereo_sgmp {

HWY_EXPORT(DifferencesOfRowOnTarget);

void LeftRightDifferencesRow(const WinnerMap& map, int y, std::uint16_t* out) {
  HWY_DYNAMIC_DISPATCH(DifferencesOfRowOnTarget)(map, y, out);
}

}  // namespace stereo_sgmp
#endif  // HWY_ONCE
