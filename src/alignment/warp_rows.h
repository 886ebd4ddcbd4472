#ifndef STEREO_SGMP_ALIGNMENT_WARP_ROWS_H_
#define STEREO_SGMP_ALIGNMENT_WARP_ROWS_H_

#include <opencv2/core.hpp>

#include "common/thread_pool.h"

namespace stereo_sgmp {

// Resamples the rows of an image: row y of `warped` is `image` at y' = scale y + offset, by cubic
// convolution (Keys 1981) with weights in 1/128; rows beyond the border repeat the last one.
// image: 8 bit, any number of channels; `warped` must be another image. The same bits everywhere.
void WarpRows(const cv::Mat& image, double scale, double offset, cv::Mat* warped, ThreadPool* pool);

}  // namespace stereo_sgmp

#endif  // STEREO_SGMP_ALIGNMENT_WARP_ROWS_H_
