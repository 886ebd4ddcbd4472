#ifndef STEREO_SGMP_MATCHER_SEEN_RANGE_H_
#define STEREO_SGMP_MATCHER_SEEN_RANGE_H_

#include <opencv2/core.hpp>

#include "common/thread_pool.h"
#include "cost/cost_rows.h"
#include "refinement/speckle.h"

namespace stereo_sgmp {

// Finds how near the surfaces of the coarse pass come. Keeps its buffers from call to call.
class SeenRange {
 public:
  // Disparities that are searched or not together.
  static constexpr int kBlock = VolumeShape::kPadding;

  // `coarse`: disparities of the coarse pass, CV_32F in coarse pixels. Returns the volume `full`
  // without the largest disparities, which none of them has: whole blocks, since that is what the
  // time goes by. All of `full` where no block can be left out. The smallest disparities stay:
  // what is far away is often hidden where the pass is least reliable, at the left side.
  VolumeShape Find(const cv::Mat& coarse, const VolumeShape& full, ThreadPool* pool);

 private:
  SpeckleFilter speckle_;
  cv::Mat reason_;
};

}  // namespace stereo_sgmp

#endif  // STEREO_SGMP_MATCHER_SEEN_RANGE_H_
