#include "matcher/seen_range.h"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <limits>

namespace stereo_sgmp {
namespace {

// A surface is a region of at least this share of the coarse pixels, in which disparities differ
// from neighbour to neighbour by a pixel at most. Whether both images agree on it does not count:
// they often don't on what comes near.
constexpr double kSmallestSurface = 0.001;
constexpr double kLargestStep = 1.0;

// Coarse disparities beyond the nearest surface: a pixel is as wide as several of the full
// resolution.
constexpr float kMargin = 1.0F;

// Where surfaces fill less of the image, the coarse pass does not know what there is.
constexpr double kFewestSurfaces = 0.5;

// The largest of the pixels without a reason, of which there have to be some.
float FindLargest(const cv::Mat& disparity, const cv::Mat& reason) {
  float largest = std::numeric_limits<float>::lowest();
  for (int y = 0; y < disparity.rows; ++y) {
    const float* row = disparity.ptr<float>(y);
    const std::uint8_t* reasons = reason.ptr(y);
    for (int x = 0; x < disparity.cols; ++x) {
      if (reasons[x] == 0) largest = std::max(largest, row[x]);
    }
  }
  return largest;
}

}  // namespace

VolumeShape SeenRange::Find(const cv::Mat& coarse, const VolumeShape& full, ThreadPool* pool) {
  if (full.disparities <= kBlock) return full;
  reason_.create(coarse.size(), CV_8U);
  reason_.setTo(0);
  speckle_.Mark(coarse, static_cast<int>(kSmallestSurface * static_cast<double>(coarse.total())),
                kLargestStep, &reason_, pool);
  const double surfaces = static_cast<double>(coarse.total()) - cv::countNonZero(reason_);
  if (surfaces < kFewestSurfaces * static_cast<double>(coarse.total())) return full;
  const double scale = static_cast<double>(full.width) / coarse.cols;
  const float nearest = FindLargest(coarse, reason_) + kMargin;
  const int last = static_cast<int>(std::ceil(static_cast<double>(nearest) * scale));
  const int wanted = std::max(1, last + 1 - full.min_disparity);
  VolumeShape narrow = full;
  narrow.disparities = std::min(full.disparities, (wanted + kBlock - 1) / kBlock * kBlock);
  return narrow;
}

}  // namespace stereo_sgmp
