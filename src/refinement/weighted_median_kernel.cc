#include "refinement/weighted_median_kernel.h"

#include <cstring>

#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "refinement/weighted_median_kernel.cc"
#include <hwy/foreach_target.h>

#include <hwy/highway.h>

HWY_BEFORE_NAMESPACE();
namespace stereo_sgmp {
namespace HWY_NAMESPACE {

namespace hn = hwy::HWY_NAMESPACE;

using DF = HWY_CAPPED(float, kMedianOverhang);
using DI = hn::Rebind<std::int32_t, DF>;
using DB = hn::Rebind<std::uint8_t, DF>;
using VF = hn::Vec<DF>;
using VI = hn::Vec<DI>;

constexpr int kWindow = (2 * kMedianRadius + 1) * (2 * kMedianRadius + 1);

// The windows of one vector of pixels, one neighbour after the other.
struct Windows {
  HWY_ALIGN float disparity[kWindow * kMedianOverhang];
  HWY_ALIGN std::int32_t weight[kWindow * kMedianOverhang];
};

// The median is one of the window's disparities from `low` to `high`.
struct Bounds {
  VF low, high;
  VI half;  // the weight to reach
};

template <int kChannels>
HWY_INLINE VI Weight(const MedianRow& row, const hn::Vec<DB> (&center)[kChannels],
                     std::ptrdiff_t neighbour) {
  const DB db;
  const DI di;
  auto largest = hn::Zero(db);
  for (int c = 0; c < kChannels; ++c) {
    const auto value = hn::LoadU(db, row.channels[c] + neighbour);
    largest = hn::Max(largest, hn::Sub(hn::Max(value, center[c]), hn::Min(value, center[c])));
  }
  return hn::Mul(hn::GatherIndex(di, row.color_weight, hn::PromoteTo(di, largest)),
                 hn::PromoteTo(di, hn::LoadU(db, row.confidence + neighbour)));
}

// Gathers the windows of the pixels from x on.
template <int kChannels>
HWY_INLINE Bounds LoadWindows(const MedianRow& row, std::ptrdiff_t x, Windows* windows) {
  const DB db;
  const DF df;
  const DI di;
  hn::Vec<DB> center[kChannels];
  for (int c = 0; c < kChannels; ++c) center[c] = hn::LoadU(db, row.channels[c] + x);
  VF low = hn::LoadU(df, row.disparity + x);
  VF high = low;
  VI total = hn::Zero(di);
  std::size_t i = 0;
  for (int dy = -kMedianRadius; dy <= kMedianRadius; ++dy) {
    for (int dx = -kMedianRadius; dx <= kMedianRadius; ++dx) {
      const std::ptrdiff_t neighbour = x + dy * row.stride + dx;
      const VF disparity = hn::LoadU(df, row.disparity + neighbour);
      const VI weight = Weight<kChannels>(row, center, neighbour);
      low = hn::Min(low, disparity);
      high = hn::Max(high, disparity);
      total = hn::Add(total, weight);
      hn::Store(disparity, df, windows->disparity + i);
      hn::Store(weight, di, windows->weight + i);
      i += hn::Lanes(df);
    }
  }
  return {low, high, hn::ShiftRight<1>(hn::Add(total, hn::Set(di, 1)))};
}

// Halves the range between the bounds and moves the bound that gives way to the next disparity of
// the window, so that every call takes at least one disparity out.
HWY_INLINE void Narrow(const Windows& windows, Bounds* bounds) {
  const DF df;
  const DI di;
  const VF one_half = hn::Set(df, 0.5f);
  const VF middle = hn::Add(hn::Mul(bounds->low, one_half), hn::Mul(bounds->high, one_half));
  // Between neighbouring floats the middle may round up to the upper one.
  const VF pivot = hn::IfThenElse(hn::Lt(middle, bounds->high), middle, bounds->low);
  VF below = bounds->low;
  VF above = bounds->high;
  VI sum = hn::Zero(di);
  const std::size_t lanes = hn::Lanes(df);
  for (std::size_t i = 0; i < kWindow * lanes; i += lanes) {
    const VF disparity = hn::Load(df, windows.disparity + i);
    const auto is_below = hn::Le(disparity, pivot);
    const VI weight = hn::Load(di, windows.weight + i);
    sum = hn::Add(sum, hn::IfThenElseZero(hn::RebindMask(di, is_below), weight));
    below = hn::Max(below, hn::IfThenElse(is_below, disparity, bounds->low));
    above = hn::Min(above, hn::IfThenElse(is_below, bounds->high, disparity));
  }
  const auto missed = hn::RebindMask(df, hn::Lt(sum, bounds->half));
  bounds->low = hn::IfThenElse(missed, above, bounds->low);
  bounds->high = hn::IfThenElse(missed, bounds->high, below);
}

template <int kChannels>
HWY_INLINE VF MedianVector(const MedianRow& row, std::ptrdiff_t x) {
  Windows windows;
  Bounds bounds = LoadWindows<kChannels>(row, x, &windows);
  for (int i = 1; i < kWindow; ++i) {
    if (hn::AllTrue(DF(), hn::Eq(bounds.low, bounds.high))) break;
    Narrow(windows, &bounds);
  }
  return bounds.high;
}

template <int kChannels>
void MedianRowOf(const MedianRow& row, int width, float* filtered) {
  const DF df;
  const int lanes = static_cast<int>(hn::Lanes(df));
  int x = 0;
  for (; x + lanes <= width; x += lanes) {
    hn::StoreU(MedianVector<kChannels>(row, x), df, filtered + x);
  }
  if (x >= width) return;
  HWY_ALIGN float rest[kMedianOverhang];
  hn::Store(MedianVector<kChannels>(row, x), df, rest);
  std::memcpy(filtered + x, rest, static_cast<std::size_t>(width - x) * sizeof(float));
}

void WeightedMedianRowOnTarget(const MedianRow& row, int width, float* filtered) {
  if (row.channel_count == 1) {
    MedianRowOf<1>(row, width, filtered);
  } else {
    MedianRowOf<3>(row, width, filtered);
  }
}

}  // namespace HWY_NAMESPACE
}  // namespace stereo_sgmp
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace stereo_sgmp {

HWY_EXPORT(WeightedMedianRowOnTarget);

void WeightedMedianRow(const MedianRow& row, int width, float* filtered) {
  HWY_DYNAMIC_DISPATCH(WeightedMedianRowOnTarget)(row, width, filtered);
}

}  // namespace stereo_sgmp
#endif
