#include "refinement/plane_smoothing.h"

#include <algorithm>
#include <cmath>

#include "refinement/plane_smoothing_kernel.h"

namespace stereo_sgmp {
namespace {

constexpr float kColorScale = 12.0f;  // channel difference at which a weight has fallen to 1/e

}  // namespace

PlaneSmoother::PlaneSmoother() {
  for (int i = 0; i < kDifferences; ++i) {
    weights_[i] = std::exp(-static_cast<float>(i) / kColorScale);
  }
}

void PlaneSmoother::Smooth(const cv::Mat& image, const cv::Mat& valid, cv::Mat* disparity,
                           ThreadPool* pool) {
  Reserve(disparity->size(), image.channels() == 1 ? 1 : kMaxChannels);
  const cv::Mat& input = *disparity;
  pool->ForRanges(input.rows, [&](int begin, int end) {
    for (int y = begin; y < end; ++y) CopyRow(image, valid, input, y);
  });
  pool->ForRanges(input.rows, [&](int begin, int end) {
    for (int y = begin; y < end; ++y) {
      SmoothingRow row;
      row.disparity = disparity_.data() + Offset(y);
      for (int c = 0; c < channels_; ++c) row.channels[c] = planes_[c].data() + Offset(y);
      row.channel_count = channels_;
      row.stride = stride_;
      row.weight = weights_;
      SmoothPlaneRow(row, input.cols, disparity->ptr<float>(y));
    }
  });
}

// Of the margins only the disparities matter: kMissingDisparity takes the pixels out.
void PlaneSmoother::Reserve(cv::Size size, int channels) {
  channels_ = channels;
  stride_ = size.width + 2 * kSmoothingRadius + kSmoothingOverhang;
  const std::size_t pixels = static_cast<std::size_t>(stride_) *
                             static_cast<std::size_t>(size.height + 2 * kSmoothingRadius);
  disparity_.Resize(pixels);
  std::fill(disparity_.data(), disparity_.data() + pixels, kMissingDisparity);
  for (int c = 0; c < channels; ++c) {
    planes_[c].Resize(pixels);
    std::fill(planes_[c].data(), planes_[c].data() + pixels, std::uint8_t{0});
  }
}

void PlaneSmoother::CopyRow(const cv::Mat& image, const cv::Mat& valid, const cv::Mat& disparity,
                            int y) {
  const float* d = disparity.ptr<float>(y);
  const std::uint8_t* is_valid = valid.ptr<std::uint8_t>(y);
  float* d_copy = disparity_.data() + Offset(y);
  for (int x = 0; x < disparity.cols; ++x) d_copy[x] = is_valid[x] != 0 ? d[x] : kMissingDisparity;
  const std::uint8_t* pixels = image.ptr<std::uint8_t>(y);
  const int step = image.channels();
  for (int c = 0; c < channels_; ++c) {
    std::uint8_t* copy = planes_[c].data() + Offset(y);
    for (int x = 0; x < disparity.cols; ++x) copy[x] = pixels[x * step + c];
  }
}

std::ptrdiff_t PlaneSmoother::Offset(int y) const {
  return (y + kSmoothingRadius) * stride_ + kSmoothingRadius;
}

}  // namespace stereo_sgmp
