// Any disparity surface as an orientation prior: SGM-GS of the paper.
#ifndef STEREO_SGMP_PRIOR_SURFACE_PRIOR_H_
#define STEREO_SGMP_PRIOR_SURFACE_PRIOR_H_

#include <algorithm>
#include <cstdint>

#include <opencv2/core.hpp>

#include "cost/cost_rows.h"
#include "prior/orientation_prior.h"

namespace stereo_sgmp {

// A 2D prior given as values: j = S^(q) - S^(p) with S^ = floor(S + 1/2) (paper, Sec. 3.2), and 0
// where either is unknown. Jumps are limited to +- the number of disparities.
class SurfacePrior : public OrientationPrior {
 public:
  // `surface` is CV_32F of the size of `shape`, in disparities; not finite where unknown.
  // Throws std::invalid_argument where its type or size is another.
  void Assign(const cv::Mat& surface, const VolumeShape& shape);

  void Jumps(int y, int x_begin, int x_end, PathStep step, JumpRow* row) const override;
  // The jump of one step, which starts and ends within the image.
  std::int16_t JumpTo(int x, int y, PathStep step) const {
    return Jump(rounded_(y - step.dy, x - step.dx), rounded_(y, x));
  }

 private:
  static constexpr std::int16_t kUnknown = INT16_MIN;

  std::int16_t Jump(std::int16_t p, std::int16_t q) const {
    if (p == kUnknown || q == kUnknown) return 0;
    return static_cast<std::int16_t>(std::clamp(q - p, -shape_.disparities, shape_.disparities));
  }

  VolumeShape shape_;
  cv::Mat_<std::int16_t> rounded_;  // S^, or kUnknown
};

}  // namespace stereo_sgmp

#endif  // STEREO_SGMP_PRIOR_SURFACE_PRIOR_H_
