#ifndef STEREO_SGMP_EVALUATION_ERROR_MAP_H_
#define STEREO_SGMP_EVALUATION_ERROR_MAP_H_

#include <opencv2/core.hpp>

#include "evaluation/metrics.h"

namespace stereo_sgmp {

// A picture, CV_8UC3, of where a disparity map (CV_32F) errs; `evaluated` as in metrics.h:
//   light gray                  correct
//   yellow, orange ... dark red  wrong, by the logarithm of the error: yellow at the bound,
//                               dark red from 16 times the bound on
//   blue                        no disparity
//   nearly black                not evaluated: occluded or not known
cv::Mat ErrorMap(const cv::Mat& disparity, const cv::Mat& truth, const cv::Mat& evaluated,
                 const ErrorBound& bound);

}  // namespace stereo_sgmp

#endif  // STEREO_SGMP_EVALUATION_ERROR_MAP_H_
