#ifndef STEREO_SGMP_TEST_PRIOR_MANHATTAN_LINE_DETECTOR_H_
#define STEREO_SGMP_TEST_PRIOR_MANHATTAN_LINE_DETECTOR_H_

#include <opencv2/core/version.hpp>

namespace stereo_sgmp {

// Before 4.5.1 OpenCV has no line segment detector, and there is nothing to test.
constexpr bool kHasLineDetector =
    CV_VERSION_MAJOR * 10000 + CV_VERSION_MINOR * 100 + CV_VERSION_REVISION >= 40501;

}  // namespace stereo_sgmp

#endif  // STEREO_SGMP_TEST_PRIOR_MANHATTAN_LINE_DETECTOR_H_
