// The aggregation written down as the paper's formulas: slow, obvious, the truth for the tests.
#ifndef STEREO_SGMP_TEST_AGGREGATION_REFERENCE_AGGREGATION_H_
#define STEREO_SGMP_TEST_AGGREGATION_REFERENCE_AGGREGATION_H_

#include <cstdint>
#include <functional>
#include <vector>

#include <opencv2/core.hpp>

#include "aggregation/winner_map.h"
#include "prior/orientation_prior.h"
#include "stereo_sgmp/options.h"

namespace stereo_sgmp::reference {

// Costs C_p(d) of a whole volume, [y][x][d] without padding.
struct Volume {
  VolumeShape shape;
  std::vector<std::uint8_t> costs;
  int unit = 1;  // as CostRows::unit

  int At(int x, int y, int d) const {
    return costs[(static_cast<std::size_t>(y) * static_cast<std::size_t>(shape.width) +
                  static_cast<std::size_t>(x)) *
                     static_cast<std::size_t>(shape.disparities) +
                 static_cast<std::size_t>(d)];
  }
};

// j_p(d) for the step from p = q - r to q = (x, y), r = (dx, dy).
using JumpFunction = std::function<int(int x, int y, PathStep step, int d)>;

// `jump` may be empty: no prior.
WinnerMap Aggregate(const Volume& volume, const cv::Mat& guide, const AggregationOptions& options,
                    const JumpFunction& jump, int jump_slack);

}  // namespace stereo_sgmp::reference

#endif  // STEREO_SGMP_TEST_AGGREGATION_REFERENCE_AGGREGATION_H_
