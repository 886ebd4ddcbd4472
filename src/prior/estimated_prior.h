// Plane priors estimated from a coarse disparity map: SGM-EPi and SGM-EPv of the paper.
#ifndef STEREO_SGMP_PRIOR_ESTIMATED_PRIOR_H_
#define STEREO_SGMP_PRIOR_ESTIMATED_PRIOR_H_

#include <atomic>
#include <functional>
#include <vector>

#include <opencv2/core.hpp>

#include "common/thread_pool.h"
#include "cost/cost_rows.h"
#include "prior/coarse_scale.h"
#include "prior/convex_hulls.h"
#include "prior/label_spread.h"
#include "prior/modal_planes.h"
#include "prior/orientation_prior.h"
#include "prior/plane_hypotheses.h"
#include "prior/steering_planes.h"
#include "prior/superpixels.h"
#include "stereo_sgmp/match_result.h"
#include "stereo_sgmp/options.h"

namespace stereo_sgmp {

// What is done on other threads while planes grow: `first`, then the `parts`, which may be done at
// the same time, then `last`, which may go on with what can wait until the function that it is
// given says that the planes have been found.
struct SideWork {
  std::function<void()> first;
  std::vector<std::function<void()>> parts;
  std::function<void(const std::function<bool()>& have_planes)> last;
};

// The chain from coarse disparities to a prior at full resolution. Keeps its buffers from frame
// to frame.
class EstimatedPrior {
 public:
  // Finds planes in `coarse` and spreads them as options.variant says. `coarse_left` is the left
  // image at the size of the coarse maps (CV_8U, 1, 3 or 4 channels; kEpi and PriorOptions::spread
  // use it), `full` the volume the prior is for. `threads` may be null. Planes grow on one thread:
  // `beside`, which must not use `threads`, is done once on others (unless the variant is kSgm),
  // and is over on return. It may be null; with one thread or none it is told at once that the
  // planes have been found.
  //
  // Returns the prior, which is this object's and holds until the next call, or null where there
  // is nothing to follow: no plane was found, or the variant is kSgm.
  // Throws std::invalid_argument where sizes or types don't fit.
  const OrientationPrior* Estimate(const PriorOptions& options, const CoarseDisparity& coarse,
                                   const cv::Mat& coarse_left, const VolumeShape& full,
                                   ThreadPool* threads, const SideWork* beside = nullptr);

  // The same prior without attraction, for the second round of PathScheme::kFourTwice.
  const OrientationPrior* parallel() const { return steering_.parallel(); }

  // What the last Estimate found.
  const PlanePriors& report() const { return report_; }

 private:
  // Both find the planes.
  const PlaneSets& SpreadOverSuperpixels(const PriorOptions& options, const CoarseDisparity& coarse,
                                         const cv::Mat& coarse_left, ThreadPool* threads,
                                         const SideWork* beside);
  const PlaneSets& SpreadOverHulls(const PriorOptions& options, const CoarseDisparity& coarse,
                                   const cv::Mat& coarse_left, ThreadPool* threads,
                                   const SideWork* beside);
  void FindPlanes(const PriorOptions& options, const CoarseDisparity& coarse,
                  std::atomic<bool>* have_planes);
  void SpreadLabels(const cv::Mat& coarse_left);
  void ScaleUp(const CoarseScale& scale);

  PlaneHypotheses hypotheses_;
  Superpixels superpixels_;
  ModalPlanes modal_;
  ModalPlanes spread_modal_;  // of the labels that have been spread
  cv::Mat unlabelled_;
  PlaneSets modal_sets_;
  ConvexHulls hulls_;
  std::vector<DisparityPlane> coarse_planes_;
  LabelSpreader spreader_;
  PlaneMap spread_;
  std::vector<DisparityPlane> full_planes_;
  SteeringPlanes steering_;
  PlanePriors report_;
};

}  // namespace stereo_sgmp

#endif  // STEREO_SGMP_PRIOR_ESTIMATED_PRIOR_H_
