#ifndef STEREO_SGMP_AGGREGATION_CONTRAST_H_
#define STEREO_SGMP_AGGREGATION_CONTRAST_H_

#include <array>
#include <cstdint>

#include <opencv2/core.hpp>

#include "aggregation/paths.h"
#include "common/thread_pool.h"

namespace stereo_sgmp {

// |dI| of neighbouring pixels along the four path axes, for P2: the largest absolute difference
// of the channels.
class Contrast {
 public:
  // `guide`: CV_8UC1 or CV_8UC3.
  void Compute(const cv::Mat& guide, ThreadPool* pool);

  // |I(q) - I(q - r)| for q = (0, y) and r the forward step of `path`; rows and columns one
  // beyond the image may be read, their values mean nothing.
  const std::uint8_t* Row(Path path, int y) const {
    return axes_[static_cast<std::size_t>(path)].ptr(y + 1) + 1;
  }

 private:
  std::array<cv::Mat, kPathsPerSweep> axes_;
};

}  // namespace stereo_sgmp

#endif  // STEREO_SGMP_AGGREGATION_CONTRAST_H_
