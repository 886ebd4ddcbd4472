#include "images/area_shrinker.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <opencv2/imgproc.hpp>

#include "images/area_kernel.h"

namespace stereo_sgmp {
namespace {

// Shares of a pixel below this are left out.
// Rows of the shrunk image that one thread makes after each other; the next one may begin with a
// row that the last one has shrunk.
constexpr int kPiece = 32;
constexpr double kSmallestShare = 1e-3;

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
  BytesToFloats(from.ptr(y), from.cols * channels, rows->source.data());
  SumTaps(rows->source.data(), channels, x_.first, x_.weights.data(), x_.taps, rows->shrunk.data());
}

void AreaShrinker::MakeRows(const cv::Mat& from, int begin, int end, cv::Mat* to,
                            Rows* rows) const {
  const auto length = static_cast<std::size_t>(to->cols) * static_cast<std::size_t>(to->channels());
  rows->source.resize(
      static_cast<std::size_t>((from.cols + x_.taps) * from.channels() + kTapOverrun));
  rows->shrunk.resize(length + kTapOverrun);
  rows->sum.resize(length);
  int shrunk_y = -1;  // the row in rows->shrunk; neighbours of `to` share one
  for (int y = begin; y < end; ++y) {
    const int first = y_.first[static_cast<std::size_t>(y)];
    const float* weight = y_.weights.data() + static_cast<std::ptrdiff_t>(y) * y_.taps;
    std::fill(rows->sum.begin(), rows->sum.end(), 0.0F);
    for (int k = 0; k < y_.count[static_cast<std::size_t>(y)]; ++k) {
      if (shrunk_y != first + k) ShrinkRow(from, first + k, rows);
      shrunk_y = first + k;
      AddWeighted(rows->shrunk.data(), weight[k], static_cast<int>(length), rows->sum.data());
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
  rows_.resize(static_cast<std::size_t>(pool->size()));
  pool->ForPieces(size.height, kPiece, [&](int thread, int begin, int end) {
    MakeRows(from, begin, end, to, &rows_[static_cast<std::size_t>(thread)]);
  });
}

}  // namespace stereo_sgmp
