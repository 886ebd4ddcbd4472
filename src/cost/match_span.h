// Where the matches of a pixel lie in a mirrored right image.
#ifndef STEREO_SGMP_COST_MATCH_SPAN_H_
#define STEREO_SGMP_COST_MATCH_SPAN_H_

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <cstring>

#include "cost/cost_rows.h"

namespace stereo_sgmp {

// A range [begin, end) of disparity indices or columns.
struct MatchSpan {
  int begin = 0;
  int end = 0;
};

// The part of [first, last] in [0, count); {0, 0} if there is none, so that rounding the begin
// down to whole vectors can't make something of nothing.
inline MatchSpan ClippedSpan(int first, int last, int count) {
  const MatchSpan span{std::max(first, 0), std::min(last + 1, count)};
  return span.begin < span.end ? span : MatchSpan{};
}

// Disparity indices whose match lies inside the right image.
inline MatchSpan InsideSpan(const VolumeShape& shape, int x) {
  const int last = x - shape.min_disparity;  // the index that matches column 0
  return ClippedSpan(last - (shape.width - 1), last, shape.disparities);
}

// Columns of the pixels whose matches all lie inside.
inline MatchSpan InnerColumns(const VolumeShape& shape) {
  return ClippedSpan(shape.min_disparity + shape.disparities - 1,
                     shape.min_disparity + shape.width - 1, shape.width);
}

// Disparity indices that pixel x is matched at: up to the last whose match lies inside, in whole
// blocks of VolumeShape::kPadding. Those beyond have no path costs.
inline int ReachedDisparities(const VolumeShape& shape, int x) {
  constexpr int kBlock = VolumeShape::kPadding;
  const int inside = std::max(x - shape.min_disparity + 1, 1);
  return std::min((inside + kBlock - 1) / kBlock * kBlock, shape.disparities);
}

// Columns [begin, end) around x whose pixels reach as many.
inline MatchSpan ColumnsOfSameReach(const VolumeShape& shape, int x) {
  constexpr int kBlock = VolumeShape::kPadding;
  const int reached = ReachedDisparities(shape, x);
  const int begin = reached <= kBlock ? 0 : (reached - 1) / kBlock * kBlock + shape.min_disparity;
  const int end = reached == shape.disparities ? shape.width : reached + shape.min_disparity;
  return {std::max(begin, 0), std::min(end, shape.width)};
}

// Column of the mirrored right image (column c holds x = width - 1 - c) that disparity index 0 of
// pixel x matches; index k matches the column k further right. May lie outside the image.
inline std::ptrdiff_t MirroredColumn(const VolumeShape& shape, int x) {
  return static_cast<std::ptrdiff_t>(shape.width) - 1 - x + shape.min_disparity;
}

// Sets the costs of one pixel that are not in `inside`.
inline void FillOutside(const VolumeShape& shape, MatchSpan inside, std::uint8_t cost,
                        std::uint8_t* costs) {
  // Most pixels have no such disparity: not even a call for them.
  if (inside.begin > 0) std::memset(costs, cost, static_cast<std::size_t>(inside.begin));
  if (inside.end < shape.disparities) {
    const int count = shape.disparities - inside.end;
    std::memset(costs + inside.end, cost, static_cast<std::size_t>(count));
  }
}

}  // namespace stereo_sgmp

#endif  // STEREO_SGMP_COST_MATCH_SPAN_H_
