#ifndef STEREO_SGMP_REFINEMENT_FILL_H_
#define STEREO_SGMP_REFINEMENT_FILL_H_

#include <opencv2/core.hpp>

#include "common/thread_pool.h"

namespace stereo_sgmp {

// Gives each hole of `disparity` (CV_32F; `valid`, CV_8U, is 0 there) the smaller of the nearest
// valid values to its left and right: what one camera does not see belongs to the background.
// Rows without a valid pixel become copies of the nearest row that has one, of the upper of two
// equally near; without any the whole image becomes `fallback`.
void FillScanlines(const cv::Mat& valid, float fallback, cv::Mat* disparity, ThreadPool* pool);

// Its two steps. FillRows does the rows [begin, end) that have a valid pixel, and says whether all
// have; FillEmptyRows needs to follow, for the whole image, where some have not.
bool FillRows(const cv::Mat& valid, int begin, int end, cv::Mat* disparity);
void FillEmptyRows(const cv::Mat& valid, float fallback, cv::Mat* disparity);

}  // namespace stereo_sgmp

#endif  // STEREO_SGMP_REFINEMENT_FILL_H_
