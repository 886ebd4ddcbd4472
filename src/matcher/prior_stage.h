#ifndef STEREO_SGMP_MATCHER_PRIOR_STAGE_H_
#define STEREO_SGMP_MATCHER_PRIOR_STAGE_H_

#include <functional>

#include <opencv2/core.hpp>

#include "aggregation/aggregator.h"
#include "common/thread_pool.h"
#include "cost/cost_rows.h"
#include "images/image_pair.h"
#include "matcher/coarse_pass.h"
#include "prior/estimated_prior.h"
#include "prior/manhattan/manhattan_prior.h"
#include "prior/normals/normal_prior.h"
#include "prior/surface_prior.h"
#include "stereo_sgmp/match_inputs.h"
#include "stereo_sgmp/match_result.h"
#include "stereo_sgmp/options.h"

namespace stereo_sgmp {

// Throws std::invalid_argument where the variant needs an input that is missing or not of the
// size and type that MatchInputs names.
void CheckInputs(Variant variant, const MatchInputs& inputs, cv::Size size);

// The orientation prior of a frame, from whichever producer the variant asks for.
class PriorStage {
 public:
  // Without priors where there is nothing to follow; they are valid until the next call. `report`
  // says what was found. `inputs` must have passed CheckInputs. `beside` is done as
  // EstimatedPrior::Estimate does it by those variants that have estimated planes, and by others
  // not; it may be null.
  PathPrior Make(const PriorOptions& options, const MatchInputs& inputs, const ImagePair& images,
                 const CoarsePass& coarse, const VolumeShape& shape, ThreadPool* pool,
                 const SideWork* beside, PlanePriors* report);

 private:
  PathPrior FromPlanes(const PriorOptions& options, const CoarseDisparity& coarse,
                       const cv::Mat& coarse_left, const VolumeShape& shape, ThreadPool* pool,
                       const SideWork* beside, PlanePriors* report);
  PathPrior FromSurface(const cv::Mat& surface, const VolumeShape& shape);
  PathPrior FromPlanesOfSurface(PriorOptions options, const cv::Mat& surface,
                                const CoarsePass& coarse, const VolumeShape& shape,
                                ThreadPool* pool, const SideWork* beside, PlanePriors* report);
  PathPrior FromManhattanWorld(const PriorOptions& options, const StereoCamera& camera,
                               const ImagePair& images, const CoarsePass& coarse,
                               const VolumeShape& shape, ThreadPool* pool, const SideWork* beside,
                               PlanePriors* report);

  EstimatedPrior estimated_;
  SurfacePrior surface_;
  NormalPriorBuilder normals_;
  ManhattanPrior manhattan_;
  cv::Mat coarse_surface_;
  cv::Mat known_;
};

}  // namespace stereo_sgmp

#endif  // STEREO_SGMP_MATCHER_PRIOR_STAGE_H_
