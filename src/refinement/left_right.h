#ifndef STEREO_SGMP_REFINEMENT_LEFT_RIGHT_H_
#define STEREO_SGMP_REFINEMENT_LEFT_RIGHT_H_

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <cstdlib>
#include <limits>

#include "aggregation/winner_map.h"

namespace stereo_sgmp {

// Compares one row of the left image with the winners of the pixels that it matches.
class LeftRightRow {
 public:
  LeftRightRow(const WinnerMap& map, int y)
      : winner_(map.winner[y]),
        right_winner_(map.right_winner[y]),
        min_disparity_(map.shape.min_disparity),
        width_(map.shape.width) {}

  // Whether the winner of the left pixel x matches a pixel of the right image.
  bool IsMatchInside(int x) const { return IsInside(MatchedColumn(x)); }

  // How far, in disparity indices, the matched right pixel's winner is from that of the left
  // pixel x; `worst` at most, and where the match lies outside or has no winner.
  int Difference(int x, int worst) const {
    if (!IsMatchInside(x)) return worst;
    const std::uint16_t right = right_winner_[MatchedColumn(x)];
    return right == WinnerMap::kNone ? worst : std::min(worst, std::abs(right - winner_[x]));
  }

  // How far, in pixels, the right image's own winner is from `disparity` at the left pixel x;
  // infinity where the match lies outside or has no winner.
  double DifferenceTo(float disparity, int x) const {
    const int x_right = x - static_cast<int>(std::lround(disparity));
    if (!IsInside(x_right) || right_winner_[x_right] == WinnerMap::kNone) {
      return std::numeric_limits<double>::infinity();
    }
    return std::abs(right_winner_[x_right] + min_disparity_ - static_cast<double>(disparity));
  }

 private:
  bool IsInside(int x_right) const { return x_right >= 0 && x_right < width_; }
  int MatchedColumn(int x) const { return x - min_disparity_ - winner_[x]; }

  const std::uint16_t* winner_;
  const std::uint16_t* right_winner_;
  int min_disparity_;
  int width_;
};

}  // namespace stereo_sgmp

#endif  // STEREO_SGMP_REFINEMENT_LEFT_RIGHT_H_
