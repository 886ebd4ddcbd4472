#ifndef STEREO_SGMP_MATCHER_DISPARITY_REFINER_H_
#define STEREO_SGMP_MATCHER_DISPARITY_REFINER_H_

#include <vector>

#include <opencv2/core.hpp>

#include "aggregation/winner_map.h"
#include "common/aligned_buffer.h"
#include "common/thread_pool.h"
#include "prior/superpixels.h"
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
  void ReadWinners(const WinnerMap& winners, const Options& options, ThreadPool* pool,
                   MatchResult* result, cv::Mat* disparity);
  // The pixels whose left and right winner agree, which tells occlusions and blunders apart from
  // the rest; all if the check is off.
  void FindAgreeing(double tolerance, int begin, int end);
  void FillBySuperpixels(const VolumeShape& shape, const cv::Mat& image, ThreadPool* pool,
                         cv::Mat* disparity);
  void Smooth(const cv::Mat& image, const RefinementOptions& refinement, ThreadPool* pool,
              const cv::Mat& confidence, cv::Mat* disparity);
  void Filter(const WinnerMap& winners, const Options& options, ThreadPool* pool,
              MatchResult* result);

  cv::Mat left_right_;  // LeftRightDifferences
  cv::Mat valid_;
  cv::Mat filled_;
  cv::Mat half_;  // the image at half the size, for superpixels
  Superpixels superpixels_;
  SuperpixelPlanes superpixel_planes_;
  PlanePropagation propagation_;
  PlaneSmoother smoother_;
  std::vector<AlignedBuffer<float>> scratch_;  // of the median, one per thread
  WeightedMedianFilter weighted_median_;
  SpeckleFilter speckle_;
};

}  // namespace stereo_sgmp

#endif  // STEREO_SGMP_MATCHER_DISPARITY_REFINER_H_
