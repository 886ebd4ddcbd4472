#ifndef STEREO_SGMP_REFINEMENT_MEDIAN_H_
#define STEREO_SGMP_REFINEMENT_MEDIAN_H_

#include <opencv2/core.hpp>

#include "common/aligned_buffer.h"

namespace stereo_sgmp {

// The rows [begin, end) of the 5x5 median of `image`, as those of `filtered`. Both are CV_32F,
// different images of one size; the border is replicated. Keeps what it needs in `scratch`.
void MedianOfRows(const cv::Mat& image, int begin, int end, AlignedBuffer<float>* scratch,
                  cv::Mat* filtered);

}  // namespace stereo_sgmp

#endif  // STEREO_SGMP_REFINEMENT_MEDIAN_H_
