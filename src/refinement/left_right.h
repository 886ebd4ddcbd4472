#ifndef STEREO_SGMP_REFINEMENT_LEFT_RIGHT_H_
#define STEREO_SGMP_REFINEMENT_LEFT_RIGHT_H_

#include <algorithm>
#include <cstdint>
#include <cstdlib>

#include "aggregation/winner_map.h"

namespace stereo_sgmp {

// Compares the winners of one row of the left image with those of the pixels they match.
class LeftRightRow {
 public:
  LeftRightRow(const WinnerMap& map, int y)
      : winner_(map.winner[y]),
        right_winner_(map.right_winner[y]),
        min_disparity_(map.shape.min_disparity),
        width_(map.shape.width) {}

  // Whether the match of the left pixel x lies within the right image.
  bool IsMatchInside(int x) const {
    const int x_right = MatchedColumn(x);
    return x_right >= 0 && x_right < width_;
  }

  // How far, in disparity indices, the matched right pixel's winner is from that of the left
  // pixel x; `worst` at most, and where the match lies outside or has no winner.
  int Difference(int x, int worst) const {
    if (!IsMatchInside(x)) return worst;
    const std::uint16_t right = right_winner_[MatchedColumn(x)];
    return right == WinnerMap::kNone ? worst : std::min(worst, std::abs(right - winner_[x]));
  }

 private:
  int MatchedColumn(int x) const { return x - min_disparity_ - winner_[x]; }

  const std::uint16_t* winner_;
  const std::uint16_t* right_winner_;
  int min_disparity_;
  int width_;
};

}  // namespace stereo_sgmp

#endif  // STEREO_SGMP_REFINEMENT_LEFT_RIGHT_H_
