#ifndef STEREO_SGMP_EVALUATION_METHODS_SPARSE_RESULT_H_
#define STEREO_SGMP_EVALUATION_METHODS_SPARSE_RESULT_H_

#include "evaluation/method_result.h"

namespace stereo_sgmp {

// The result of a method that gives nothing but a disparity map (CV_32F, not finite where it is
// invalid): the holes of `dense` filled from the background, a confidence of 1 where the map is
// valid and 0 elsewhere.
MethodResult SparseResult(const cv::Mat& disparity);

}  // namespace stereo_sgmp

#endif  // STEREO_SGMP_EVALUATION_METHODS_SPARSE_RESULT_H_
