#ifndef STEREO_SGMP_REFINEMENT_CONFIDENCE_H_
#define STEREO_SGMP_REFINEMENT_CONFIDENCE_H_

#include <opencv2/core.hpp>

#include "aggregation/winner_map.h"
#include "stereo_sgmp/options.h"

namespace stereo_sgmp {

// How far each winner can be trusted, CV_32F in 0..1, high = good.
//
// kPeakDifference: the distance of the second best cost to the best (0 where there is no second),
// averaged over the 5x5 pixels around, less 100 for each index by which the left and the right
// winner differ, up to 10. The costs of PathScheme::kFour count twice, as if of eight paths. Mapped
// to 0..1 by a strictly rising function that comes close to the share of pixels that are right
// within one pixel.
// kUncertainty: 1 / (1 + U_p / (N P1)) for N path evaluations, 1 where all paths agree.
// `left_right` is what LeftRightDifferences makes. Of the rows [begin, end) alone; `confidence` has
// its size.
void ComputeConfidence(const WinnerMap& map, const cv::Mat& left_right, ConfidenceMeasure measure,
                       const AggregationOptions& aggregation, int begin, int end,
                       cv::Mat* confidence);

// U_p of the paper as CV_32F, of the rows [begin, end) alone; `uncertainty` has its size.
void UncertaintyImage(const WinnerMap& map, int begin, int end, cv::Mat* uncertainty);

}  // namespace stereo_sgmp

#endif  // STEREO_SGMP_REFINEMENT_CONFIDENCE_H_
