#include "refinement/weighted_median.h"

#include <algorithm>
#include <cmath>

#include "refinement/weighted_median_kernel.h"

namespace stereo_sgmp {
namespace {

constexpr float kColorScale = 12.0f;  // channel difference at which a weight has fallen to 1/e
constexpr float kColorUnit = 65535.0f;
// Together 0.02 + confidence in units of 1/250: at most 255.
constexpr float kConfidenceUnit = 250.0f;
constexpr float kBaseWeight = 0.02f * kConfidenceUnit;

// Repeats the first and the last value of a row into its margins.
template <class T>
void ReplicateEnds(int width, T* row) {
  std::fill(row - kMedianRadius, row, row[0]);
  std::fill(row + width, row + width + kMedianRadius + kMedianOverhang, row[width - 1]);
}

}  // namespace

WeightedMedianFilter::WeightedMedianFilter() {
  for (int i = 0; i < kDifferences; ++i) {
    const float weight = std::exp(-static_cast<float>(i) / kColorScale);
    color_weights_[i] = static_cast<std::int32_t>(std::lround(kColorUnit * weight));
  }
}

void WeightedMedianFilter::Apply(const cv::Mat& image, const cv::Mat& confidence,
                                 const cv::Mat& disparity, cv::Mat* filtered, ThreadPool* pool) {
  const cv::Size size = disparity.size();
  Reserve(size, image.channels() == 1 ? 1 : kMaxChannels);
  pool->ForRanges(size.height + 2 * kMedianRadius, [&](int begin, int end) {
    for (int i = begin; i < end; ++i) CopyRow(image, confidence, disparity, i - kMedianRadius);
  });
  filtered->create(size, CV_32F);
  pool->ForRanges(size.height, [&](int begin, int end) {
    for (int y = begin; y < end; ++y) FilterRow(size.width, y, filtered->ptr<float>(y));
  });
}

void WeightedMedianFilter::Reserve(cv::Size size, int channels) {
  channels_ = channels;
  stride_ = size.width + 2 * kMedianRadius + kMedianOverhang;
  const std::size_t pixels =
      static_cast<std::size_t>(stride_) * static_cast<std::size_t>(size.height + 2 * kMedianRadius);
  disparity_.Resize(pixels);
  confidence_.Resize(pixels);
  for (int c = 0; c < channels; ++c) planes_[c].Resize(pixels);
}

// Fills row y of the copies, which may lie above or below the image.
void WeightedMedianFilter::CopyRow(const cv::Mat& image, const cv::Mat& confidence,
                                   const cv::Mat& disparity, int y) {
  const int width = disparity.cols;
  const int source = std::clamp(y, 0, disparity.rows - 1);
  float* d_copy = disparity_.data() + Offset(y);
  std::copy_n(disparity.ptr<float>(source), width, d_copy);
  ReplicateEnds(width, d_copy);
  const float* input = confidence.ptr<float>(source);
  std::uint8_t* weights = confidence_.data() + Offset(y);
  for (int x = 0; x < width; ++x) {
    weights[x] = cv::saturate_cast<std::uint8_t>(kConfidenceUnit * input[x] + kBaseWeight);
  }
  ReplicateEnds(width, weights);
  const std::uint8_t* pixels = image.ptr<std::uint8_t>(source);
  const int step = image.channels();
  for (int c = 0; c < channels_; ++c) {
    std::uint8_t* copy = planes_[c].data() + Offset(y);
    for (int x = 0; x < width; ++x) copy[x] = pixels[x * step + c];
    ReplicateEnds(width, copy);
  }
}

void WeightedMedianFilter::FilterRow(int width, int y, float* filtered) const {
  MedianRow row;
  row.disparity = disparity_.data() + Offset(y);
  row.confidence = confidence_.data() + Offset(y);
  for (int c = 0; c < channels_; ++c) row.channels[c] = planes_[c].data() + Offset(y);
  row.channel_count = channels_;
  row.stride = stride_;
  row.color_weight = color_weights_;
  WeightedMedianRow(row, width, filtered);
}

std::ptrdiff_t WeightedMedianFilter::Offset(int y) const {
  return (y + kMedianRadius) * stride_ + kMedianRadius;
}

}  // namespace stereo_sgmp
