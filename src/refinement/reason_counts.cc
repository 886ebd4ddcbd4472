#include "refinement/reason_counts.h"

#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "refinement/reason_counts.cc"
#include <hwy/foreach_target.h>
#include <hwy/highway.h>

HWY_BEFORE_NAMESPACE();
namespace stereo_sgmp {
namespace HWY_NAMESPACE {
namespace hn = hwy::HWY_NAMESPACE;

void CountReasonsOnTarget(const std::uint8_t* reasons, int width, ReasonCounts* counts) {
  const hn::ScalableTag<std::uint8_t> d;
  const int lanes = static_cast<int>(hn::Lanes(d));
  int x = 0;
  for (; x + lanes <= width; x += lanes) {
    const auto here = hn::LoadU(d, reasons + x);
    std::uint8_t reason = 0;
    for (int& count : *counts) {
      count += static_cast<int>(hn::CountTrue(d, hn::Eq(here, hn::Set(d, reason++))));
    }
  }
  for (; x < width; ++x) ++(*counts)[reasons[x]];
}

}  // namespace HWY_NAMESPACE
}  // namespace stereo_sgmp
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace stereo_sgmp {

HWY_EXPORT(CountReasonsOnTarget);

void CountReasonsInRow(const std::uint8_t* reasons, int width, ReasonCounts* counts) {
  HWY_DYNAMIC_DISPATCH(CountReasonsOnTarget)(reasons, width, counts);
}

}  // namespace stereo_sgmp
#endif  // HWY_ONCE
