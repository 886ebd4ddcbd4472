#ifndef STEREO_SGMP_ALIGNMENT_RECTIFICATION_RESIDUAL_H_
#define STEREO_SGMP_ALIGNMENT_RECTIFICATION_RESIDUAL_H_

#include <vector>

#include <opencv2/core.hpp>

#include "alignment/row_matches.h"

namespace stereo_sgmp {

// What rectification has left over: row y of the left image is row y' = a y + b of the right.
struct ResidualFit {
  double a = 1.0;
  double b = 0.0;  // pixels
  int inliers = 0;
  // Enough inliers, spread over the rows, and a plausible model. The identity where it is false.
  bool reliable = false;
  double median_offset = 0.0;  // median |y' - y| over all matches, pixels
  double residual = 0.0;       // median |y' - (a y + b)| over the inliers, pixels
  double max_shift = 0.0;      // largest |y' - y| of the model over the image, pixels
};

// Robust fit to matches in an image of `height` rows. Deterministic.
ResidualFit FitRows(const std::vector<RowMatch>& matches, int height);

// The fit for one pair: CV_8UC1 of one size. Pairs that are too small or have too little texture
// give the identity, not reliable.
ResidualFit FitRectificationResidual(const cv::Mat& left, const cv::Mat& right, int min_disparity,
                                     int num_disparities);

}  // namespace stereo_sgmp

#endif  // STEREO_SGMP_ALIGNMENT_RECTIFICATION_RESIDUAL_H_
