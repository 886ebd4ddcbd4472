#ifndef STEREO_SGMP_REFINEMENT_WEIGHTED_MEDIAN_H_
#define STEREO_SGMP_REFINEMENT_WEIGHTED_MEDIAN_H_

#include <cstddef>
#include <cstdint>

#include <opencv2/core.hpp>

#include "common/aligned_buffer.h"
#include "common/thread_pool.h"

namespace stereo_sgmp {

// A median that keeps to the edges of the image. Each pixel p takes the smallest disparity v of
// its 7x7 window such that the neighbours of disparity <= v hold at least half of the window's
// weight. A neighbour q weighs exp(-D(p, q) / 12) (0.02 + confidence(q)), D being the largest
// channel difference; the two factors are rounded to 1/65535 and 1/250, so that sums are exact.
// The border is replicated. Keeps its buffers from call to call.
class WeightedMedianFilter {
 public:
  WeightedMedianFilter();

  // `image`: 8 bit, gray, BGR or BGRA. `confidence`: CV_32F, 0 .. 1. `disparity`: CV_32F, finite;
  // all of one size. `filtered` becomes CV_32F and may be `disparity` itself.
  // Results do not depend on the SIMD target or the number of threads.
  void Apply(const cv::Mat& image, const cv::Mat& confidence, const cv::Mat& disparity,
             cv::Mat* filtered, ThreadPool* pool);

 private:
  static constexpr int kDifferences = 256;
  static constexpr int kMaxChannels = 3;

  void Reserve(cv::Size size, int channels);
  void CopyRow(const cv::Mat& image, const cv::Mat& confidence, const cv::Mat& disparity, int y);
  void FilterRow(int width, int y, float* filtered) const;
  std::ptrdiff_t Offset(int y) const;

  std::int32_t color_weights_[kDifferences];
  int channels_ = 0;
  std::ptrdiff_t stride_ = 0;
  // Copies with the border replicated, so that windows need no bounds.
  AlignedBuffer<float> disparity_;
  AlignedBuffer<std::uint8_t> confidence_;
  AlignedBuffer<std::uint8_t> planes_[kMaxChannels];
};

}  // namespace stereo_sgmp

#endif  // STEREO_SGMP_REFINEMENT_WEIGHTED_MEDIAN_H_
