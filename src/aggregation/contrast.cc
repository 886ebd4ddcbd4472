#include "aggregation/contrast.h"

#include <algorithm>
#include <cstdlib>

namespace stereo_sgmp {
namespace {

// out[x] = max(out[x], |at[x] - before[x]|)
void RaiseToDifference(const std::uint8_t* at, const std::uint8_t* before, int count,
                       std::uint8_t* out) {
  for (int x = 0; x < count; ++x) {
    const int difference = std::abs(static_cast<int>(at[x]) - static_cast<int>(before[x]));
    out[x] = static_cast<std::uint8_t>(std::max<int>(out[x], difference));
  }
}

}  // namespace

void Contrast::Compute(const cv::Mat& guide, ThreadPool* pool) {
  channels_.resize(static_cast<std::size_t>(guide.channels()));
  cv::split(guide, channels_);
  for (cv::Mat& axis : axes_) axis.create(guide.rows + 2, guide.cols + 2, CV_8U);
  pool->ForRanges(guide.rows + 2, [&](int begin, int end) {
    for (int row = begin; row < end; ++row) {
      for (std::size_t i = 0; i < axes_.size(); ++i) {
        const PathStep step = kForwardSteps[i];
        std::uint8_t* out = axes_[i].ptr(row);
        std::fill(out, out + guide.cols + 2, std::uint8_t{0});
        const int y = row - 1;
        if (y < 0 || y >= guide.rows || y - step.dy < 0) continue;
        const int x_begin = std::max(0, step.dx);
        const int count = guide.cols - std::abs(step.dx);
        for (const cv::Mat& channel : channels_) {
          RaiseToDifference(channel.ptr(y) + x_begin, channel.ptr(y - step.dy) + x_begin - step.dx,
                            count, out + 1 + x_begin);
        }
      }
    }
  });
}

}  // namespace stereo_sgmp
