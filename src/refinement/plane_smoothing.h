#ifndef STEREO_SGMP_REFINEMENT_PLANE_SMOOTHING_H_
#define STEREO_SGMP_REFINEMENT_PLANE_SMOOTHING_H_

#include <cstddef>
#include <cstdint>

#include <opencv2/core.hpp>

#include "common/aligned_buffer.h"
#include "common/thread_pool.h"

namespace stereo_sgmp {

// Moves each disparity onto the plane that fits the disparities around it: least squares over
// every second pixel of every second row of 9x9, weighted by exp(-difference / 12) of the largest
// channel difference of the image, over the neighbours within 1 + 0.1 max(|dx|, |dy|) pixels of
// disparity. A small ridge keeps the slopes steady; no disparity moves by more than one pixel.
// Keeps its buffers from call to call.
class PlaneSmoother {
 public:
  PlaneSmoother();

  // `image`: 8 bit, gray, BGR or BGRA. `valid`: CV_8U, 0 for pixels whose disparity tells nothing
  // of their neighbours; they are moved all the same. `disparity`: CV_32F, all of one size.
  // Results do not depend on the SIMD target or the number of threads.
  void Smooth(const cv::Mat& image, const cv::Mat& valid, cv::Mat* disparity, ThreadPool* pool);

 private:
  static constexpr int kDifferences = 256;
  static constexpr int kMaxChannels = 3;

  void Reserve(cv::Size size, int channels);
  void CopyRow(const cv::Mat& image, const cv::Mat& valid, const cv::Mat& disparity, int y);
  std::ptrdiff_t Offset(int y) const;

  float weights_[kDifferences];
  int channels_ = 0;
  std::ptrdiff_t stride_ = 0;
  // Copies with a margin all around, so that windows need no bounds.
  AlignedBuffer<float> disparity_;
  AlignedBuffer<std::uint8_t> planes_[kMaxChannels];
};

}  // namespace stereo_sgmp

#endif  // STEREO_SGMP_REFINEMENT_PLANE_SMOOTHING_H_
