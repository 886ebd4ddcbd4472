#include "refinement/median.h"

#include <algorithm>
#include <cstddef>
#include <cstdint>

#include <opencv2/imgproc.hpp>

namespace stereo_sgmp {
namespace {

constexpr int kRadius = 2;

// The rows [begin, end) of the filtered image; `strip` takes them with the rows around that the
// windows reach into, whose own medians lack their neighbours and are left behind.
void FilterStrip(const cv::Mat& image, int begin, int end, cv::Mat* strip, cv::Mat* filtered) {
  const int first = std::max(begin - kRadius, 0);
  const int last = std::min(end + kRadius, image.rows);
  cv::medianBlur(image.rowRange(first, last), *strip, 2 * kRadius + 1);
  strip->rowRange(begin - first, end - first).copyTo(filtered->rowRange(begin, end));
}

}  // namespace

void MedianFilter::Apply(const cv::Mat& image, cv::Mat* filtered, ThreadPool* pool) {
  filtered->create(image.size(), CV_32F);
  const int parts = pool->size();
  strips_.resize(static_cast<std::size_t>(parts));
  pool->Run([&](int part) {
    const int begin = static_cast<int>(std::int64_t{image.rows} * part / parts);
    const int end = static_cast<int>(std::int64_t{image.rows} * (part + 1) / parts);
    if (begin == end) return;
    FilterStrip(image, begin, end, &strips_[static_cast<std::size_t>(part)], filtered);
  });
}

}  // namespace stereo_sgmp
