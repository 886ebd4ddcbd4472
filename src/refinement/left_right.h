#ifndef STEREO_SGMP_REFINEMENT_LEFT_RIGHT_H_
#define STEREO_SGMP_REFINEMENT_LEFT_RIGHT_H_

#include <opencv2/core.hpp>

#include "aggregation/winner_map.h"
#include "common/thread_pool.h"

namespace stereo_sgmp {

// How far, in disparity indices, the winner of the right pixel that each left pixel matches is
// from the left one's, CV_16U; WinnerMap::kNone where the match lies outside the right image or
// has no winner.
void LeftRightDifferences(const WinnerMap& map, cv::Mat* difference, ThreadPool* pool);

// 255 where the winners of both sides are less than `worst` indices apart, else 0.
void LeftRightMask(const cv::Mat& difference, int worst, cv::Mat* mask, ThreadPool* pool);

}  // namespace stereo_sgmp

#endif  // STEREO_SGMP_REFINEMENT_LEFT_RIGHT_H_
