#include "images/area_shrinker.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <opencv2/imgproc.hpp>

namespace stereo_sgmp {
namespace {

// Shares of a pixel below this are left out.
constexpr double kSmallestShare = 1e-3;

// The pixels of a shrunk row, of which `first` are the first taps. Adds the taps up in order, as
// floats round. kTaps: their number if it is known, else 0.
template <int kChannels, int kTaps>
void SumTaps(const float* source, const std::vector<int>& first, const float* weight, int taps,
             float* out) {
  if (kTaps != 0) taps = kTaps;
  for (const int column : first) {
    const float* tap = source + static_cast<std::ptrdiff_t>(column) * kChannels;
    for (int c = 0; c < kChannels; ++c) {
      float sum = 0.0F;
      for (int k = 0; k < taps; ++k) sum += tap[k * kChannels + c] * weight[k];
      *out++ = sum;
    }
    weight += taps;
  }
}

// For the usual numbers of taps, those of factors from 2 to 4, unrolled.
template <int kChannels>
auto SumTapsOf(int taps) {
  switch (taps) {
    case 3:
      return SumTaps<kChannels, 3>;
    case 4:
      return SumTaps<kChannels, 4>;
    case 5:
      return SumTaps<kChannels, 5>;
    default:
      return SumTaps<kChannels, 0>;
  }
}

bool IsWholeMultiple(int from, int to) { return from % to == 0; }

}  // namespace

void AreaShrinker::Axis::Assign(int from, int to) {
  const double scale = static_cast<double>(from) / to;
  taps = static_cast<int>(std::ceil(scale)) + 1;
  first.assign(static_cast<std::size_t>(to), 0);
  count.assign(static_cast<std::size_t>(to), 0);
  weights.assign(static_cast<std::size_t>(to) * static_cast<std::size_t>(taps), 0.0F);
  for (int i = 0; i < to; ++i) {
    const double begin = i * scale;
    const double end = begin + scale;
    const double length = std::min(scale, from - begin);
    const int whole_end = std::min(static_cast<int>(std::floor(end)), from - 1);
    const int whole_begin = std::min(static_cast<int>(std::ceil(begin)), whole_end);
    const bool has_left = whole_begin - begin > kSmallestShare;
    float* weight = weights.data() + static_cast<std::ptrdiff_t>(i) * taps;
    int n = 0;
    if (has_left) weight[n++] = static_cast<float>((whole_begin - begin) / length);
    for (int k = whole_begin; k < whole_end; ++k) weight[n++] = static_cast<float>(1.0 / length);
    if (end - whole_end > kSmallestShare) {
      weight[n++] = static_cast<float>(std::min(std::min(end - whole_end, 1.0), length) / length);
    }
    first[static_cast<std::size_t>(i)] = has_left ? whole_begin - 1 : whole_begin;
    count[static_cast<std::size_t>(i)] = n;
  }
}

void AreaShrinker::ShrinkRow(const cv::Mat& from, int y, Rows* rows) const {
  const int channels = from.channels();
  const int length = from.cols * channels;
  const std::uint8_t* source = from.ptr<std::uint8_t>(y);
  for (int i = 0; i < length; ++i) {
    rows->source[static_cast<std::size_t>(i)] = static_cast<float>(source[i]);
  }
  const auto sum_taps = channels == 1 ? SumTapsOf<1>(x_.taps) : SumTapsOf<3>(x_.taps);
  sum_taps(rows->source.data(), x_.first, x_.weights.data(), x_.taps, rows->shrunk.data());
}

void AreaShrinker::MakeRows(const cv::Mat& from, int begin, int end, cv::Mat* to,
                            Rows* rows) const {
  const auto length = static_cast<std::size_t>(to->cols) * static_cast<std::size_t>(to->channels());
  rows->source.resize(static_cast<std::size_t>((from.cols + x_.taps) * from.channels()));
  rows->shrunk.resize(length);
  rows->sum.resize(length);
  int shrunk_y = -1;  // the row in rows->shrunk; neighbours of `to` share one
  for (int y = begin; y < end; ++y) {
    const int first = y_.first[static_cast<std::size_t>(y)];
    const float* weight = y_.weights.data() + static_cast<std::ptrdiff_t>(y) * y_.taps;
    std::fill(rows->sum.begin(), rows->sum.end(), 0.0F);
    for (int k = 0; k < y_.count[static_cast<std::size_t>(y)]; ++k) {
      if (shrunk_y != first + k) ShrinkRow(from, first + k, rows);
      shrunk_y = first + k;
      for (std::size_t i = 0; i < length; ++i) rows->sum[i] += weight[k] * rows->shrunk[i];
    }
    std::uint8_t* out = to->ptr<std::uint8_t>(y);
    for (std::size_t i = 0; i < length; ++i) out[i] = cv::saturate_cast<std::uint8_t>(rows->sum[i]);
  }
}

void AreaShrinker::Shrink(const cv::Mat& from, cv::Size size, cv::Mat* to, ThreadPool* pool) {
  if (IsWholeMultiple(from.cols, size.width) && IsWholeMultiple(from.rows, size.height)) {
    cv::resize(from, *to, size, 0, 0, cv::INTER_AREA);  // in whole numbers, which is fast
    return;
  }
  to->create(size, from.type());
  x_.Assign(from.cols, size.width);
  y_.Assign(from.rows, size.height);
  const int parts = pool->size();
  rows_.resize(static_cast<std::size_t>(parts));
  pool->Run([&](int part) {
    const int begin = static_cast<int>(std::int64_t{size.height} * part / parts);
    const int end = static_cast<int>(std::int64_t{size.height} * (part + 1) / parts);
    MakeRows(from, begin, end, to, &rows_[static_cast<std::size_t>(part)]);
  });
}

}  // namespace stereo_sgmp
