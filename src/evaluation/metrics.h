#ifndef STEREO_SGMP_EVALUATION_METRICS_H_
#define STEREO_SGMP_EVALUATION_METRICS_H_

#include <opencv2/core.hpp>

namespace stereo_sgmp {

enum class ZeroTruth {
  kUnknown,    // disparities <= 0 in the ground truth mean "not known", as in Middlebury's files
  kDisparity,  // they are disparities like all others
};

// The pixels that are scored, CV_8U, 255 or 0: where the ground truth (CV_32F) is finite and
// known and the mask (CV_8U, may be empty) is 255, that is, seen by both cameras.
cv::Mat EvaluatedPixels(const cv::Mat& truth, const cv::Mat& mask,
                        ZeroTruth zero = ZeroTruth::kUnknown);

// Of the evaluated pixels those whose disparity (CV_32F) is off by more than `threshold` pixels,
// CV_8U, 255 or 0. A disparity that is not finite is wrong.
cv::Mat BadPixels(const cv::Mat& disparity, const cv::Mat& truth, const cv::Mat& evaluated,
                  double threshold);

// Their share of the evaluated pixels, percent. NaN where no pixel is evaluated.
double BadPercent(const cv::Mat& disparity, const cv::Mat& truth, const cv::Mat& evaluated,
                  double threshold);

// Mean of |disparity - truth| over the evaluated pixels whose disparity is finite, pixels. NaN
// where there is none.
double AverageError(const cv::Mat& disparity, const cv::Mat& truth, const cv::Mat& evaluated);

}  // namespace stereo_sgmp

#endif  // STEREO_SGMP_EVALUATION_METRICS_H_
