#include "evaluation/methods/sparse_result.h"

#include "common/thread_pool.h"
#include "evaluation/metrics.h"
#include "refinement/fill.h"

namespace stereo_sgmp {

MethodResult SparseResult(const cv::Mat& disparity) {
  MethodResult result;
  result.raw = disparity;
  result.valid = IsFinite(disparity);
  result.dense = disparity.clone();
  ThreadPool pool(1);
  FillScanlines(result.valid, 0.0F, &result.dense, &pool);
  result.valid.convertTo(result.confidence, CV_32F, 1.0 / 255.0);
  return result;
}

}  // namespace stereo_sgmp
