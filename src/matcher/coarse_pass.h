#ifndef STEREO_SGMP_MATCHER_COARSE_PASS_H_
#define STEREO_SGMP_MATCHER_COARSE_PASS_H_

#include <cstddef>

#include <opencv2/core.hpp>

#include "aggregation/aggregator.h"
#include "aggregation/winner_map.h"
#include "common/thread_pool.h"
#include "cost/cost_computer.h"
#include "cost/kept_costs.h"
#include "cost/radiometric_fit.h"
#include "images/image_pair.h"
#include "prior/confident_pixels.h"
#include "stereo_sgmp/options.h"

namespace stereo_sgmp {

// Plain SGM on the images shrunk by PriorOptions::coarse_factor: the source of the estimated
// priors (Section 4.1), and of the radiometric fit of the pair.
class CoarsePass {
 public:
  void Run(const Options& options, const ImagePair& full, ThreadPool* pool);

  const cv::Mat& image() const { return images_.left_color(); }
  const cv::Mat& disparity() const { return disparity_; }  // CV_32F, coarse pixels
  const cv::Mat& confident() const { return confident_.mask(); }

  // What `kind` needs to know of the exposures of the pair that Run has seen.
  RadiometricFit FitRadiometry(CostKind kind);

  // The volume of the coarse pass for a full-resolution one.
  static VolumeShape Shape(const Options& options, cv::Size full);

 private:
  ImagePair images_;
  CostComputer costs_;
  KeptCosts kept_costs_;
  Aggregator aggregator_;
  WinnerMap winners_;
  cv::Mat disparity_;
  ConfidentPixels confident_;
  RadiometricFitter radiometry_;
};

}  // namespace stereo_sgmp

#endif  // STEREO_SGMP_MATCHER_COARSE_PASS_H_
