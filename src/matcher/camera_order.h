#ifndef STEREO_SGMP_MATCHER_CAMERA_ORDER_H_
#define STEREO_SGMP_MATCHER_CAMERA_ORDER_H_

#include <opencv2/core.hpp>

#include "stereo_sgmp/options.h"

namespace stereo_sgmp {

// Whether the pair matches far better with left and right exchanged, over the same range of
// disparities. Matches the pair twice at a small size: a few milliseconds. Images as Matcher takes
// them.
bool LookSwapped(const cv::Mat& left, const cv::Mat& right, const Options& options);

}  // namespace stereo_sgmp

#endif  // STEREO_SGMP_MATCHER_CAMERA_ORDER_H_
