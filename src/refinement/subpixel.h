#ifndef STEREO_SGMP_REFINEMENT_SUBPIXEL_H_
#define STEREO_SGMP_REFINEMENT_SUBPIXEL_H_

#include <opencv2/core.hpp>

#include "aggregation/winner_map.h"
#include "common/thread_pool.h"
#include "stereo_sgmp/options.h"

namespace stereo_sgmp {

// The disparity of each pixel in pixels, CV_32F, min_disparity included. With S0 the cost of the
// winner and S-, S+ those of its neighbours it lies beside the winner by
//   kEquiangular: (S- - S+) / (2 (max(S-, S+) - S0)),
//   kParabola:    (S- - S+) / (2 (S- - 2 S0 + S+)),
//   kBlend:       the mean of the two,
// all within [-1/2, 1/2]; by 0 at the ends of the range and where a denominator is 0.
void RefineSubpixel(const WinnerMap& map, Subpixel method, cv::Mat* disparity, ThreadPool* pool);

// Of the rows [begin, end) alone. `disparity` has its size.
void RefineSubpixelRows(const WinnerMap& map, Subpixel method, int begin, int end,
                        cv::Mat* disparity);

}  // namespace stereo_sgmp

#endif  // STEREO_SGMP_REFINEMENT_SUBPIXEL_H_
