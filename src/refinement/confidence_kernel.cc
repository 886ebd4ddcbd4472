#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "refinement/confidence_kernel.cc"
#include <hwy/foreach_target.h>  // must come before highway.h

#include <hwy/highway.h>

#include "refinement/confidence_kernel.h"

#ifndef STEREO_SGMP_REFINEMENT_CONFIDENCE_KERNEL_ONCE
#define STEREO_SGMP_REFINEMENT_CONFIDENCE_KERNEL_ONCE

#include <algorithm>
#include <cstddef>

namespace stereo_sgmp {
namespace confidence {

constexpr int kRadius = 2;  // of the window that peak differences are averaged over
constexpr int kMaxLeftRight = 10;
constexpr float kLeftRightWeight = 100.0f;  // cost units for an index of difference

// Calibration on real pairs (mixed cost, P1 = 120, eight directions), in cost units: the measure
// at which half of the pixels are right, and the scale on which their share rises from there.
constexpr float kEvenMeasure = 420.0f;
constexpr float kMeasureScale = 430.0f;

// The columns that are averaged at once: what is between the steps stays in the nearest cache.
constexpr int kChunk = 512;

// Number of pixels of a window of kRadius around `center` within [0, size).
inline int WindowLength(int center, int size) {
  return std::min(center + kRadius, size - 1) - std::max(center - kRadius, 0) + 1;
}

}  // namespace confidence
}  // namespace stereo_sgmp

#endif  // STEREO_SGMP_REFINEMENT_CONFIDENCE_KERNEL_ONCE

HWY_BEFORE_NAMESPACE();
namespace stereo_sgmp {
namespace HWY_NAMESPACE {
namespace hn = hwy::HWY_NAMESPACE;

using Floats = hn::ScalableTag<float>;
using Indices = hn::Rebind<std::int32_t, Floats>;
using Shorts = hn::Rebind<std::uint16_t, Floats>;
using V = hn::Vec<Floats>;

HWY_INLINE V ToFloats(hn::Vec<Shorts> values) {
  return hn::ConvertTo(Floats(), hn::PromoteTo(Indices(), values));
}

// sums[i] = peak differences of the column x + i over the rows of the window around row y; 0 for
// columns outside. All sums here are integers below 2^24, hence exact in any order.
void SumColumns(const WinnerMap& map, int y, int x, int count, float* sums) {
  const Floats d;
  const Shorts d16;
  const auto none = hn::Set(d16, WinnerMap::kNone);
  const int lanes = static_cast<int>(hn::Lanes(d));
  std::fill(sums, sums + count, 0.0f);
  const int first = std::max(0, -x);
  const int last = std::min(count, map.winner.cols - x);
  const int y_begin = std::max(y - confidence::kRadius, 0);
  const int y_end = std::min(y + confidence::kRadius + 1, map.winner.rows);
  int i = first;
  for (; i + lanes <= last; i += lanes) {
    V sum = hn::Zero(d);
    for (int v = y_begin; v < y_end; ++v) {
      const auto second = hn::LoadU(d16, map.second[v] + x + i);
      const auto rise = hn::Sub(second, hn::LoadU(d16, map.cost[v] + x + i));
      sum = hn::Add(sum, ToFloats(hn::IfThenZeroElse(hn::Eq(second, none), rise)));
    }
    hn::StoreU(sum, d, sums + i);
  }
  for (; i < last; ++i) {
    for (int v = y_begin; v < y_end; ++v) {
      const std::uint16_t second = map.second[v][x + i];
      if (second != WinnerMap::kNone) sums[i] += static_cast<float>(second - map.cost[v][x + i]);
    }
  }
}

// Rises from 0 to 1 with 1/2 at 0. Approaches its ends slowly enough that large values, which a
// logistic function would round to 1, stay in order.
HWY_INLINE V ToUnitInterval(V t) {
  const Floats d;
  const V one = hn::Set(d, 1.0f);
  const V half = hn::Set(d, 0.5f);
  const V size = hn::Abs(t);
  const V rise = hn::Mul(hn::Mul(half, t), hn::Add(one, size));
  const V bound = hn::Add(one, hn::Mul(size, hn::Add(one, size)));
  return hn::Add(half, hn::Div(rise, bound));
}

// sums: of the columns x - 2 to x + lanes + 1, of which the window of each pixel has `counts`
// pixels.
HWY_INLINE V Confidence(const float* sums, V counts, float weight, hn::Vec<Shorts> left_right) {
  const Floats d;
  V sum = hn::LoadU(d, sums);
  for (int k = 1; k <= 2 * confidence::kRadius; ++k) sum = hn::Add(sum, hn::LoadU(d, sums + k));
  const auto apart = hn::Min(left_right, hn::Set(Shorts(), confidence::kMaxLeftRight));
  const V penalty = hn::Mul(hn::Set(d, confidence::kLeftRightWeight), ToFloats(apart));
  const V weighted = hn::Mul(hn::Set(d, weight), hn::Div(sum, counts));
  const V measure = hn::Sub(weighted, penalty);
  return ToUnitInterval(hn::Div(hn::Sub(measure, hn::Set(d, confidence::kEvenMeasure)),
                                hn::Set(d, confidence::kMeasureScale)));
}

// Of the columns [x, x + count) of row y; `left_right` and `out` are those of x.
void ConfidenceOfChunk(const WinnerMap& map, const std::uint16_t* left_right, int y, int x,
                       int count, float weight, float* out) {
  const Floats d;
  const int lanes = static_cast<int>(hn::Lanes(d));
  // Whole vectors are read at the end.
  constexpr std::size_t kOverrun = HWY_MAX_BYTES / sizeof(float);
  constexpr std::size_t kSpan = confidence::kChunk + 2 * confidence::kRadius;
  HWY_ALIGN float sums[kSpan + kOverrun] = {};
  HWY_ALIGN float counts[confidence::kChunk + kOverrun] = {};
  HWY_ALIGN float results[kOverrun];
  HWY_ALIGN std::uint16_t apart[kOverrun] = {};
  SumColumns(map, y, x - confidence::kRadius, count + 2 * confidence::kRadius, sums);
  const int rows = confidence::WindowLength(y, map.winner.rows);
  for (int i = 0; i < count; ++i) {
    counts[i] = static_cast<float>(rows * confidence::WindowLength(x + i, map.winner.cols));
  }
  int i = 0;
  for (; i + lanes <= count; i += lanes) {
    const auto differences = hn::LoadU(Shorts(), left_right + i);
    hn::StoreU(Confidence(sums + i, hn::Load(d, counts + i), weight, differences), d, out + i);
  }
  if (i == count) return;
  const int rest = count - i;  // less than a vector
  for (int k = 0; k < rest; ++k) apart[k] = left_right[i + k];
  const auto differences = hn::Load(Shorts(), apart);
  hn::Store(Confidence(sums + i, hn::Load(d, counts + i), weight, differences), d, results);
  for (int k = 0; k < rest; ++k) out[i + k] = results[k];
}

void ConfidenceOfRow(const WinnerMap& map, const std::uint16_t* left_right, int y, float weight,
                     float* row) {
  const int width = map.winner.cols;
  for (int x = 0; x < width; x += confidence::kChunk) {
    const int count = std::min(confidence::kChunk, width - x);
    ConfidenceOfChunk(map, left_right + x, y, x, count, weight, row + x);
  }
}

}  // namespace HWY_NAMESPACE
}  // namespace stereo_sgmp
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace stereo_sgmp {

HWY_EXPORT(ConfidenceOfRow);

void PeakDifferenceRow(const WinnerMap& map, const std::uint16_t* left_right, int y, float weight,
                       float* row) {
  HWY_DYNAMIC_DISPATCH(ConfidenceOfRow)(map, left_right, y, weight, row);
}

}  // namespace stereo_sgmp
#endif  // HWY_ONCE
