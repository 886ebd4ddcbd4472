// Planes along the three directions of a Manhattan world: SGM-MW of the paper.
#ifndef STEREO_SGMP_PRIOR_MANHATTAN_MANHATTAN_PRIOR_H_
#define STEREO_SGMP_PRIOR_MANHATTAN_MANHATTAN_PRIOR_H_

#include <optional>
#include <vector>

#include <opencv2/core.hpp>

#include "common/thread_pool.h"
#include "cost/cost_rows.h"
#include "prior/label_spread.h"
#include "prior/manhattan/manhattan_planes.h"
#include "prior/manhattan/vanishing_points.h"
#include "prior/orientation_prior.h"
#include "prior/plane_hypotheses.h"
#include "prior/plane_set_painter.h"
#include "prior/steering_planes.h"
#include "stereo_sgmp/match_result.h"
#include "stereo_sgmp/options.h"
#include "stereo_sgmp/stereo_camera.h"

namespace stereo_sgmp {

// The chain from the lines of the left image and coarse disparities to a prior at full
// resolution. Keeps its buffers from frame to frame.
class ManhattanPrior {
 public:
  // `left` is the left image in full size (CV_8U, 1, 3 or 4 channels), `coarse_left` the same at
  // the size of the coarse maps, `camera` its camera, `full` the volume the prior is for. `threads`
  // may be null.
  //
  // Returns the prior, which is this object's and holds until the next call, or null where there
  // is nothing to follow: the lines show no Manhattan world (frame() tells), or no plane was
  // found. Throws std::invalid_argument where sizes or types don't fit or the camera can't be, and
  // std::runtime_error where OpenCV finds no lines (see FindLineSegments).
  const OrientationPrior* Estimate(const PriorOptions& options, const CoarseDisparity& coarse,
                                   const cv::Mat& left, const cv::Mat& coarse_left,
                                   const StereoCamera& camera, const VolumeShape& full,
                                   ThreadPool* threads);

  // The same prior without attraction, for the second round of PathScheme::kFourTwice.
  const OrientationPrior* parallel() const { return steering_.parallel(); }

  // What the last Estimate found.
  const std::optional<ManhattanFrame>& frame() const { return frame_; }
  const PlanePriors& report() const { return report_; }

 private:
  void Spread(const std::vector<ManhattanPlane>& planes, const CoarseScale& scale,
              const cv::Mat& disparity);
  void SpreadToRest(const cv::Mat& coarse_left, const cv::Mat& disparity);

  std::optional<ManhattanFrame> frame_;
  PlaneHypotheses hypotheses_;
  std::vector<DisparityPlane> coarse_planes_;
  std::vector<DisparityPlane> full_planes_;
  PlaneSetPainter painter_;
  LabelSpreader spreader_;
  cv::Mat spread_;
  SteeringPlanes steering_;
  PlanePriors report_;
};

}  // namespace stereo_sgmp

#endif  // STEREO_SGMP_PRIOR_MANHATTAN_MANHATTAN_PRIOR_H_
