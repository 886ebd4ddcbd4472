#ifndef STEREO_SGMP_IMAGES_AREA_SHRINKER_H_
#define STEREO_SGMP_IMAGES_AREA_SHRINKER_H_

#include <vector>

#include <opencv2/core.hpp>

#include "common/thread_pool.h"

namespace stereo_sgmp {

// Averages the area of each pixel of a smaller image: cv::resize with INTER_AREA bit by bit (as
// where OpenCV has no fused multiply-add), which runs on one thread. Keeps its buffers from call to
// call.
class AreaShrinker {
 public:
  // `from`: CV_8U of 1 or 3 channels; `size` is not larger than it.
  void Shrink(const cv::Mat& from, cv::Size size, cv::Mat* to, ThreadPool* pool);

 private:
  // What the pixels of one axis are made of: `taps` neighbours each, from `first` on, with weights
  // that are 0 where there are fewer.
  struct Axis {
    int taps = 0;
    std::vector<int> first;
    std::vector<int> count;
    std::vector<float> weights;  // taps for each pixel

    void Assign(int from, int to);
  };

  // What a thread needs.
  struct Rows {
    std::vector<float> source;  // one row of `from`, padded
    std::vector<float> shrunk;  // the same, shrunk in x
    std::vector<float> sum;     // a row of `to`
  };

  void ShrinkRow(const cv::Mat& from, int y, Rows* rows) const;
  void MakeRows(const cv::Mat& from, int begin, int end, cv::Mat* to, Rows* rows) const;

  Axis x_;
  Axis y_;
  std::vector<Rows> rows_;
};

}  // namespace stereo_sgmp

#endif  // STEREO_SGMP_IMAGES_AREA_SHRINKER_H_
