#ifndef STEREO_SGMP_COST_RADIOMETRIC_FIT_H_
#define STEREO_SGMP_COST_RADIOMETRIC_FIT_H_

#include <opencv2/core.hpp>

namespace stereo_sgmp {

// How the gray levels of the right image become those of the left: I_l = gain I_r + offset.
struct RadiometricFit {
  double gain = 1.0;
  double offset = 0.0;     // gray levels
  double ad_weight = 1.0;  // 0..1: how far absolute differences can be trusted
};

// Robust fit between the matched pixels of a pair. `left`, `right`: CV_8UC1; `disparity`: CV_32F,
// pixels of these images; `confident`: CV_8U, 0 where the disparity is not to be used; all of one
// size. The fit stays the identity unless it lowers the median absolute deviation of the gray
// levels by 20 %. Vignetting, reflections and the like remain: ad_weight falls from 1 to 0 as the
// remaining deviation rises from 3 to 8 gray levels. Too few matches give the identity.
RadiometricFit FitRadiometry(const cv::Mat& left, const cv::Mat& right, const cv::Mat& disparity,
                             const cv::Mat& confident);

}  // namespace stereo_sgmp

#endif  // STEREO_SGMP_COST_RADIOMETRIC_FIT_H_
