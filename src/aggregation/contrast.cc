#include "aggregation/contrast.h"

#include <algorithm>
#include <cstddef>
#include <cstdlib>

#include "images/pixel_difference_kernel.h"

namespace stereo_sgmp {

void Contrast::Compute(const cv::Mat& guide, ThreadPool* pool) {
  const int channels = guide.channels();
  for (cv::Mat& axis : axes_) axis.create(guide.rows + 2, guide.cols + 2, CV_8U);
  pool->ForRanges(guide.rows, [&](int begin, int end) {
    for (int y = begin; y < end; ++y) {
      for (std::size_t i = 0; i < axes_.size(); ++i) {
        const PathStep step = kForwardSteps[i];
        if (y < step.dy) continue;
        const int x = std::max(0, step.dx);
        const int count = guide.cols - std::abs(step.dx);
        PixelDifferences(guide.ptr(y - step.dy) + channels * (x - step.dx),
                         guide.ptr(y) + channels * x, channels, count, 0,
                         axes_[i].ptr(y + 1) + 1 + x);
      }
    }
  });
}

}  // namespace stereo_sgmp
