#ifndef STEREO_SGMP_MATCHER_DISPARITY_REFINER_H_
#define STEREO_SGMP_MATCHER_DISPARITY_REFINER_H_

#include <opencv2/core.hpp>

#include "aggregation/winner_map.h"
#include "common/thread_pool.h"
#include "prior/superpixels.h"
#include "refinement/median.h"
#include "refinement/plane_propagation.h"
#include "refinement/plane_smoothing.h"
#include "refinement/speckle.h"
#include "refinement/superpixel_planes.h"
#include "refinement/weighted_median.h"
#include "stereo_sgmp/match_result.h"
#include "stereo_sgmp/options.h"

namespace stereo_sgmp {

// From the winners to the images of a MatchResult: sub-pixel, confidence, validity, filling and
// smoothing, in the order of the options.
class DisparityRefiner {
 public:
  // `image`: the left image, CV_8UC1 or CV_8UC3.
  void Run(const WinnerMap& winners, const cv::Mat& image, const Options& options, ThreadPool* pool,
           MatchResult* result);

 private:
  // The pixels whose left and right winner agree, which tells occlusions and blunders apart from
  // the rest; all if the check is off.
  void FindAgreeing(double tolerance, ThreadPool* pool);
  void MakeDense(const VolumeShape& shape, const cv::Mat& image, const Options& options,
                 ThreadPool* pool, MatchResult* result);
  void FillHoles(const VolumeShape& shape, const cv::Mat& image,
                 const RefinementOptions& refinement, ThreadPool* pool, cv::Mat* disparity);

  cv::Mat left_right_;  // LeftRightDifferences
  cv::Mat valid_;
  cv::Mat filled_;
  cv::Mat half_;  // the image at half the size, for superpixels
  Superpixels superpixels_;
  SuperpixelPlanes superpixel_planes_;
  PlanePropagation propagation_;
  PlaneSmoother smoother_;
  MedianFilter median_;
  WeightedMedianFilter weighted_median_;
  SpeckleFilter speckle_;
};

}  // namespace stereo_sgmp

#endif  // STEREO_SGMP_MATCHER_DISPARITY_REFINER_H_
