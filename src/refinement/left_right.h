#ifndef STEREO_SGMP_REFINEMENT_LEFT_RIGHT_H_
#define STEREO_SGMP_REFINEMENT_LEFT_RIGHT_H_

#include <opencv2/core.hpp>

#include "aggregation/winner_map.h"

namespace stereo_sgmp {

// Both are for the rows [begin, end) of images that have their sizes.

// How far, in disparity indices, the winner of the right pixel that each left pixel matches is
// from the left one's, CV_16U; WinnerMap::kNone where the match lies outside the right image or
// has no winner.
void LeftRightDifferences(const WinnerMap& map, int begin, int end, cv::Mat* difference);

// 255 where the winners of both sides are less than `worst` indices apart, else 0; CV_8U.
void LeftRightMask(const cv::Mat& difference, int worst, int begin, int end, cv::Mat* mask);

}  // namespace stereo_sgmp

#endif  // STEREO_SGMP_REFINEMENT_LEFT_RIGHT_H_
