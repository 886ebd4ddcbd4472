#ifndef STEREO_SGMP_REFINEMENT_MEDIAN_H_
#define STEREO_SGMP_REFINEMENT_MEDIAN_H_

#include <vector>

#include <opencv2/core.hpp>

#include "common/thread_pool.h"

namespace stereo_sgmp {

// The 5x5 median, cv::medianBlur on several threads. Keeps its buffers from call to call.
class MedianFilter {
 public:
  // `image` and `filtered` are CV_32F and different images; the border is replicated.
  void Apply(const cv::Mat& image, cv::Mat* filtered, ThreadPool* pool);

 private:
  std::vector<cv::Mat> strips_;  // one per thread
};

}  // namespace stereo_sgmp

#endif  // STEREO_SGMP_REFINEMENT_MEDIAN_H_
