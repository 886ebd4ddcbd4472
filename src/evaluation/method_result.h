#ifndef STEREO_SGMP_EVALUATION_METHOD_RESULT_H_
#define STEREO_SGMP_EVALUATION_METHOD_RESULT_H_

#include <limits>

#include <opencv2/core.hpp>

namespace stereo_sgmp {

// What a stereo method says of a scene; maps of the size of the left image.
struct MethodResult {
  cv::Mat raw;    // CV_32F, unfiltered and not filled; not finite where the method gives nothing
  cv::Mat dense;  // CV_32F, a value at every pixel
  cv::Mat valid;  // CV_8U, 255 where the method itself vouches for `dense`, else 0
  cv::Mat uncertainty;  // CV_32F, low = good; empty where the method has none
  cv::Mat confidence;   // CV_32F, high = good
  double seconds = std::numeric_limits<double>::quiet_NaN();  // NaN where it is not known
};

}  // namespace stereo_sgmp

#endif  // STEREO_SGMP_EVALUATION_METHOD_RESULT_H_
