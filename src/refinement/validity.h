#ifndef STEREO_SGMP_REFINEMENT_VALIDITY_H_
#define STEREO_SGMP_REFINEMENT_VALIDITY_H_

#include <opencv2/core.hpp>

#include "aggregation/winner_map.h"
#include "stereo_sgmp/options.h"

namespace stereo_sgmp {

// Why each pixel is to be distrusted: an InvalidReason per pixel, CV_8U, the first that applies
// of all but kSpeckle. `disparity`, CV_32F, is the map that is checked from left to right: the
// smoothed one, since a wrong winner that the smoothing has mended agrees with the right image.
// `confidence` is the image that ComputeConfidence makes, `left_right` that of
// LeftRightDifferences.
//
// Range applies to more than two disparities, as both are ends otherwise. A negative
// lr_tolerance switches left-right off. Uniqueness asks, as OpenCV's StereoSGBM does, that the
// best cost be lower than the second best by uniqueness_ratio percent of the latter.
// Of the rows [begin, end) alone; `reason` has its size.
void FindInvalid(const WinnerMap& map, const cv::Mat& left_right, const cv::Mat& disparity,
                 const cv::Mat& confidence, const FilterOptions& options, int begin, int end,
                 cv::Mat* reason);

}  // namespace stereo_sgmp

#endif  // STEREO_SGMP_REFINEMENT_VALIDITY_H_
