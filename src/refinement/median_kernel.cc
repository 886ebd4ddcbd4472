#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "refinement/median_kernel.cc"
#include <hwy/foreach_target.h>  // must come before highway.h

#include <hwy/highway.h>

#include "refinement/median_kernel.h"

#ifndef STEREO_SGMP_REFINEMENT_MEDIAN_KERNEL_ONCE
#define STEREO_SGMP_REFINEMENT_MEDIAN_KERNEL_ONCE

#include <algorithm>
#include <array>
#include <cstddef>

namespace stereo_sgmp {
namespace median {

// Of a vector. Whole vectors are read and written at the end of a row.
constexpr int kMostLanes = 16;

// Of the sorted columns of a row: room for the replicated ends.
inline int Stride(int width) { return width + 2 * kMedianRadius + 2 * kMostLanes; }

}  // namespace median
}  // namespace stereo_sgmp

#endif  // STEREO_SGMP_REFINEMENT_MEDIAN_KERNEL_ONCE

HWY_BEFORE_NAMESPACE();
namespace stereo_sgmp {
namespace HWY_NAMESPACE {
namespace hn = hwy::HWY_NAMESPACE;

using Floats = hn::CappedTag<float, median::kMostLanes>;
using V = hn::Vec<Floats>;

// The median of 25 values from their order in rows and columns: each column is sorted once and
// used by five windows. Then the values of each rank are sorted across the columns. A value of
// which more than twelve others are known to be smaller or larger is not the median; what can be
// are three diagonals of the square of ranks: its second diagonal, five values, and four each
// below and above it. Each of the lower four is at most two of the five, and so on upwards: the
// median is that of the middle three of the five, the largest below and the smallest above.

HWY_INLINE void Sort(V& low, V& high) {
  const V larger = hn::Max(low, high);
  low = hn::Min(low, high);
  high = larger;
}

HWY_INLINE void Sort5(V& a, V& b, V& c, V& d, V& e) {
  Sort(a, b);
  Sort(d, e);
  Sort(c, e);
  Sort(c, d);
  Sort(b, e);
  Sort(a, d);
  Sort(a, c);
  Sort(b, d);
  Sort(b, c);
}

struct Rank {
  V v[kMedianSide];
};

HWY_INLINE Rank LoadRank(const float* columns) {
  const Floats d;
  return {{hn::LoadU(d, columns), hn::LoadU(d, columns + 1), hn::LoadU(d, columns + 2),
           hn::LoadU(d, columns + 3), hn::LoadU(d, columns + 4)}};
}

// The largest two of five, into the last two places.
HWY_INLINE void SortLargestTwo(Rank& r) {
  Sort(r.v[0], r.v[1]);
  Sort(r.v[2], r.v[3]);
  const V second = hn::Max(hn::Max(r.v[0], r.v[2]), hn::Min(r.v[1], r.v[3]));
  const V first = hn::Max(r.v[1], r.v[3]);
  r.v[3] = hn::Max(second, hn::Min(first, r.v[4]));
  r.v[4] = hn::Max(first, r.v[4]);
}

// The smallest two, into the first two places.
HWY_INLINE void SortSmallestTwo(Rank& r) {
  Sort(r.v[0], r.v[1]);
  Sort(r.v[2], r.v[3]);
  const V second = hn::Min(hn::Min(r.v[1], r.v[3]), hn::Max(r.v[0], r.v[2]));
  const V first = hn::Min(r.v[0], r.v[2]);
  r.v[1] = hn::Min(second, hn::Max(first, r.v[4]));
  r.v[0] = hn::Min(first, r.v[4]);
}

HWY_INLINE void SortAll(Rank& r) { Sort5(r.v[0], r.v[1], r.v[2], r.v[3], r.v[4]); }

// Of the columns at `columns` to `columns` + 4, whose ranks stand `stride` apart.
HWY_INLINE V MedianOfColumns(const float* columns, std::ptrdiff_t stride) {
  Rank r0 = LoadRank(columns);
  Rank r1 = LoadRank(columns + stride);
  Rank r2 = LoadRank(columns + 2 * stride);
  Rank r3 = LoadRank(columns + 3 * stride);
  Rank r4 = LoadRank(columns + 4 * stride);
  SortLargestTwo(r0);
  SortAll(r1);
  SortAll(r2);
  SortAll(r3);
  SortSmallestTwo(r4);
  const V below = hn::Max(hn::Max(r0.v[3], r1.v[2]), hn::Max(r2.v[1], r3.v[0]));
  const V above = hn::Min(hn::Min(r1.v[4], r2.v[3]), hn::Min(r3.v[2], r4.v[1]));
  V a = r0.v[4];
  V b = r1.v[3];
  V c = r2.v[2];
  V d = r3.v[1];
  V e = r4.v[0];
  Sort5(a, b, c, d, e);
  const V low = hn::Min(below, above);
  const V high = hn::Max(below, above);
  return hn::Max(hn::Max(b, hn::Min(c, high)), hn::Min(d, low));
}

void SortColumns(const std::array<const float*, kMedianSide>& rows, int x, float* columns,
                 std::ptrdiff_t stride) {
  const Floats d;
  V v0 = hn::LoadU(d, rows[0] + x);
  V v1 = hn::LoadU(d, rows[1] + x);
  V v2 = hn::LoadU(d, rows[2] + x);
  V v3 = hn::LoadU(d, rows[3] + x);
  V v4 = hn::LoadU(d, rows[4] + x);
  Sort5(v0, v1, v2, v3, v4);
  hn::StoreU(v0, d, columns);
  hn::StoreU(v1, d, columns + stride);
  hn::StoreU(v2, d, columns + 2 * stride);
  hn::StoreU(v3, d, columns + 3 * stride);
  hn::StoreU(v4, d, columns + 4 * stride);
}

void MedianRowOnTarget(const std::array<const float*, kMedianSide>& rows, int width, float* scratch,
                       float* out) {
  const Floats d;
  const int lanes = static_cast<int>(hn::Lanes(d));
  const std::ptrdiff_t stride = median::Stride(width);
  float* const columns = scratch + kMedianRadius;  // of rank 0, at column 0
  int x = 0;
  for (; x + lanes <= width; x += lanes) SortColumns(rows, x, columns + x, stride);
  if (x < width) {
    float rest[kMedianSide][median::kMostLanes] = {};
    std::array<const float*, kMedianSide> rest_rows;
    for (std::size_t i = 0; i < kMedianSide; ++i) {
      std::copy(rows[i] + x, rows[i] + width, rest[i]);
      rest_rows[i] = rest[i];
    }
    SortColumns(rest_rows, 0, columns + x, stride);
  }
  for (int rank = 0; rank < kMedianSide; ++rank) {
    float* const row = columns + rank * stride;
    std::fill(row - kMedianRadius, row, row[0]);
    // As far as whole vectors read, so that they read numbers.
    std::fill(row + width, row + width + kMedianRadius + median::kMostLanes, row[width - 1]);
  }
  for (x = 0; x + lanes <= width; x += lanes) {
    hn::StoreU(MedianOfColumns(scratch + x, stride), d, out + x);
  }
  if (x >= width) return;
  float rest[median::kMostLanes];
  hn::StoreU(MedianOfColumns(scratch + x, stride), d, rest);
  std::copy(rest, rest + width - x, out + x);
}

}  // namespace HWY_NAMESPACE
}  // namespace stereo_sgmp
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace stereo_sgmp {

HWY_EXPORT(MedianRowOnTarget);

void MedianRow(const std::array<const float*, kMedianSide>& rows, int width, float* scratch,
               float* out) {
  HWY_DYNAMIC_DISPATCH(MedianRowOnTarget)(rows, width, scratch, out);
}

int MedianScratch(int width) { return kMedianSide * median::Stride(width); }

}  // namespace stereo_sgmp
#endif  // HWY_ONCE
