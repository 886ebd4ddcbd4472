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

// From where on an error counts as bad: above both bounds.
struct ErrorBound {
  double pixels = 0.0;
  double share = 0.0;  // of the true disparity; KITTI 2015 takes 3 pixels and 0.05
};

// Of the evaluated pixels those whose disparity (CV_32F) is bad, CV_8U, 255 or 0. A disparity
// that is not finite is bad.
cv::Mat BadPixels(const cv::Mat& disparity, const cv::Mat& truth, const cv::Mat& evaluated,
                  const ErrorBound& bound);

// The pixels of a mask (CV_8U, 255 or 0) among the evaluated ones, percent of those. NaN where no
// pixel is evaluated.
double PercentOf(const cv::Mat& evaluated, const cv::Mat& mask);

// The bad pixels' share of the evaluated ones, percent; NaN as PercentOf.
double BadPercent(const cv::Mat& disparity, const cv::Mat& truth, const cv::Mat& evaluated,
                  const ErrorBound& bound);

// 255 where a value (CV_32F) is neither infinite nor NaN, else 0.
cv::Mat IsFinite(const cv::Mat& values);

// Mean of |disparity - truth| over the evaluated pixels whose disparity is finite, pixels. NaN
// where there is none.
double AverageError(const cv::Mat& disparity, const cv::Mat& truth, const cv::Mat& evaluated);

}  // namespace stereo_sgmp

#endif  // STEREO_SGMP_EVALUATION_METRICS_H_
