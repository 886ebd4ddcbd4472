// Any disparity surface as an orientation prior: SGM-GS of the paper.
#ifndef STEREO_SGMP_PRIOR_SURFACE_PRIOR_H_
#define STEREO_SGMP_PRIOR_SURFACE_PRIOR_H_

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

 private:
  VolumeShape shape_;
  cv::Mat_<std::int16_t> rounded_;  // S^
};

}  // namespace stereo_sgmp

#endif  // STEREO_SGMP_PRIOR_SURFACE_PRIOR_H_
