#ifndef STEREO_SGMP_MATCHER_CAMERA_ORDER_H_
#define STEREO_SGMP_MATCHER_CAMERA_ORDER_H_

#include <opencv2/core.hpp>

#include "stereo_sgmp/options.h"

namespace stereo_sgmp {

// Whether the pair matches better with left and right exchanged, in most parts of the image; where
// both orders match as well, as on perfectly repeated texture, it says no. Matches the pair twice
// at a small size: some ten milliseconds. Images as Matcher takes them.
bool LookSwapped(const cv::Mat& left, const cv::Mat& right, const Options& options);

}  // namespace stereo_sgmp

#endif  // STEREO_SGMP_MATCHER_CAMERA_ORDER_H_
