// Depth from disparity, without ROS.
#ifndef STEREO_SGMP_DEPTH_H_
#define STEREO_SGMP_DEPTH_H_

#include <opencv2/core.hpp>

#include "stereo_sgmp/match_result.h"
#include "stereo_sgmp/stereo_camera.h"

namespace stereo_sgmp {

// The depths of the filtered disparity, CV_32F in the unit of the baseline; NaN where it is invalid
// or the point lies at infinity or behind it. Throws as StereoCamera::Check.
void ComputeDepth(const MatchResult& result, const StereoCamera& camera, cv::Mat* depth);

// Disparities first, first + 1, ... of a search.
struct DisparityRange {
  int first = 0;
  int count = 0;
};

// The fewest disparities that cover all depths from `nearest` to `farthest`, in the unit of the
// baseline; `farthest` may be infinite. Throws std::invalid_argument naming the values unless
// 0 < nearest < farthest, and as StereoCamera::Check.
DisparityRange RangeOfDepths(const StereoCamera& camera, double nearest, double farthest);

}  // namespace stereo_sgmp

#endif  // STEREO_SGMP_DEPTH_H_
