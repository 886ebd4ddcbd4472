#ifndef STEREO_SGMP_AGGREGATION_WINNER_MAP_H_
#define STEREO_SGMP_AGGREGATION_WINNER_MAP_H_

#include <cstdint>

#include <opencv2/core.hpp>

#include "cost/cost_rows.h"

namespace stereo_sgmp {

// What the last aggregation pass reads off the aggregated costs S(p, d) of each pixel.
// Disparities are indices, d = min_disparity + index; ties go to the smallest index.
struct WinnerMap {
  static constexpr std::uint16_t kNone = 0xFFFF;

  VolumeShape shape;
  cv::Mat_<std::uint16_t> winner;       // argmin_d S
  cv::Mat_<std::uint16_t> cost;         // S at the winner
  cv::Mat_<std::uint16_t> cost_below;   // S at winner - 1; kNone at the first disparity
  cv::Mat_<std::uint16_t> cost_above;   // S at winner + 1; kNone at the last disparity
  cv::Mat_<std::uint16_t> second;       // min S over |index - winner| > 1; kNone if there is none
  cv::Mat_<std::uint16_t> uncertainty;  // U_p = min_d S - sum_r min_d L_r
  // Of the pixels of the right image: argmin_d S(x + d, y, d) over the left pixels that can
  // match; kNone where no left pixel can.
  cv::Mat_<std::uint16_t> right_winner;

  void Create(const VolumeShape& volume);
};

}  // namespace stereo_sgmp

#endif  // STEREO_SGMP_AGGREGATION_WINNER_MAP_H_
