#include "refinement/subpixel.h"

#include <algorithm>
#include <cstdint>

namespace stereo_sgmp {
namespace {

// Offsets from the rises left = S- - S0 and right = S+ - S0, whole numbers >= 0. A denominator
// that is not 0 is hence at least 2, and the maximum with 1 stands for "0 where it is 0" without
// a branch in the way of the vectoriser.

float NoOffset(float /*left*/, float /*right*/) { return 0.0f; }

float EquiangularOffset(float left, float right) {
  return (left - right) / std::max(1.0f, 2.0f * std::max(left, right));
}

float ParabolaOffset(float left, float right) {
  return (left - right) / std::max(1.0f, 2.0f * (left + right));
}

float BlendOffset(float left, float right) {
  return 0.5f * (EquiangularOffset(left, right) + ParabolaOffset(left, right));
}

template <float (*kOffset)(float, float)>
void RefineRows(const WinnerMap& map, int begin, int end, cv::Mat* disparity) {
  const float min_disparity = static_cast<float>(map.shape.min_disparity);
  for (int y = begin; y < end; ++y) {
    const std::uint16_t* winner = map.winner[y];
    const std::uint16_t* cost = map.cost[y];
    const std::uint16_t* below = map.cost_below[y];
    const std::uint16_t* above = map.cost_above[y];
    float* out = disparity->ptr<float>(y);
    for (int x = 0; x < disparity->cols; ++x) {
      const bool inside = below[x] != WinnerMap::kNone && above[x] != WinnerMap::kNone;
      const float offset =
          kOffset(static_cast<float>(below[x] - cost[x]), static_cast<float>(above[x] - cost[x]));
      out[x] = min_disparity + static_cast<float>(winner[x]) + (inside ? offset : 0.0f);
    }
  }
}

using RowsFunction = void (*)(const WinnerMap&, int, int, cv::Mat*);

RowsFunction RowsFunctionOf(Subpixel method) {
  switch (method) {
    case Subpixel::kEquiangular:
      return RefineRows<EquiangularOffset>;
    case Subpixel::kParabola:
      return RefineRows<ParabolaOffset>;
    case Subpixel::kBlend:
      return RefineRows<BlendOffset>;
    case Subpixel::kNone:
      break;
  }
  return RefineRows<NoOffset>;
}

}  // namespace

void RefineSubpixel(const WinnerMap& map, Subpixel method, cv::Mat* disparity, ThreadPool* pool) {
  disparity->create(map.winner.size(), CV_32F);
  const RowsFunction refine_rows = RowsFunctionOf(method);
  pool->ForRanges(disparity->rows,
                  [&](int begin, int end) { refine_rows(map, begin, end, disparity); });
}

}  // namespace stereo_sgmp
