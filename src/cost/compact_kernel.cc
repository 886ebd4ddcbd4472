#include "cost/compact_kernel.h"

#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "cost/compact_kernel.cc"
#include <hwy/foreach_target.h>
#include <hwy/highway.h>

#include "cost/compact-inl.h"

HWY_BEFORE_NAMESPACE();
namespace stereo_sgmp {
namespace HWY_NAMESPACE {
namespace hn = hwy::HWY_NAMESPACE;

void DivideCosts(int unit, std::size_t count, std::uint8_t* costs) {
  const hn::CappedTag<std::uint8_t, 64> d;
  const CostDivider<decltype(d)> divide(unit);
  for (std::size_t i = 0; i < count; i += hn::Lanes(d)) {
    hn::Store(divide(hn::Load(d, costs + i)), d, costs + i);
  }
}

}  // namespace HWY_NAMESPACE
}  // namespace stereo_sgmp
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace stereo_sgmp {

HWY_EXPORT(DivideCosts);

void CompactCosts(int unit, std::size_t count, std::uint8_t* costs) {
  if (unit > 1) HWY_DYNAMIC_DISPATCH(DivideCosts)(unit, count, costs);
}

}  // namespace stereo_sgmp
#endif  // HWY_ONCE
