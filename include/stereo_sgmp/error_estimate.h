// How exact the disparities and depths of a result are, pixel by pixel.
#ifndef STEREO_SGMP_ERROR_ESTIMATE_H_
#define STEREO_SGMP_ERROR_ESTIMATE_H_

#include <opencv2/core.hpp>

#include "stereo_sgmp/match_result.h"
#include "stereo_sgmp/options.h"
#include "stereo_sgmp/stereo_camera.h"

namespace stereo_sgmp {

// One standard deviation of the filtered disparity, CV_32F, pixels; NaN where it is invalid. Of
// all pixels with the same estimate about 68 % are that close to the truth; errors have a longer
// tail than a normal distribution, since some pixels are mismatched. From the confidence, by a
// calibration against ground truth, and from the step of the disparities.
// `options` are those of the match.
void EstimateDisparityError(const MatchResult& result, const Options& options, cv::Mat* error);

// The same of the depths, in the unit of the baseline: f b / (d + doffs)^2 times the error of the
// disparity. NaN where the disparity is invalid or the point at infinity. Throws as
// StereoCamera::Check, and std::invalid_argument when the maps differ in size.
void EstimateDepthError(const MatchResult& result, const cv::Mat& disparity_error,
                        const StereoCamera& camera, cv::Mat* error);

// The standard deviation of a disparity in pixels, at a confidence from 0 to 1.
double DisparityErrorAt(double confidence, const Options& options);

// The standard deviation of a depth in the unit of the baseline, given that of its disparity.
double DepthErrorAt(const StereoCamera& camera, double depth, double disparity_error);

}  // namespace stereo_sgmp

#endif  // STEREO_SGMP_ERROR_ESTIMATE_H_
