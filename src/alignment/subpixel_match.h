#ifndef STEREO_SGMP_ALIGNMENT_SUBPIXEL_MATCH_H_
#define STEREO_SGMP_ALIGNMENT_SUBPIXEL_MATCH_H_

#include <opencv2/core.hpp>

namespace stereo_sgmp {

// Moves `match` to where `right` looks most like `left` around `point` (Lucas and Kanade 1981,
// translation, gain and offset of the gray levels free), from at most 2 pixels away. Images:
// CV_8UC1. Returns false where it does not converge, leaves the image, or the patches differ.
bool RefineMatch(const cv::Mat& left, const cv::Mat& right, cv::Point point, cv::Point2d* match);

}  // namespace stereo_sgmp

#endif  // STEREO_SGMP_ALIGNMENT_SUBPIXEL_MATCH_H_
