#include "refinement/fill.h"

#include <algorithm>
#include <cstdint>
#include <cstdlib>

namespace stereo_sgmp {
namespace {

constexpr auto kIsValid = [](std::uint8_t valid) { return valid != 0; };

bool HasValid(const cv::Mat& valid, int y) {
  const std::uint8_t* row = valid.ptr<std::uint8_t>(y);
  return std::any_of(row, row + valid.cols, kIsValid);
}

// Leaves rows without a valid pixel as they are.
void FillRow(const std::uint8_t* valid, int width, float* disparity) {
  const std::uint8_t* const valid_end = valid + width;
  const auto next_valid = [&](int from) {
    return static_cast<int>(std::find_if(valid + from, valid_end, kIsValid) - valid);
  };
  int begin = 0;
  while (begin < width) {
    if (valid[begin] != 0) {
      ++begin;
      continue;
    }
    const int end = next_valid(begin);
    if (begin == 0 && end == width) return;
    const float left = disparity[begin == 0 ? end : begin - 1];
    const float right = disparity[end == width ? begin - 1 : end];
    std::fill(disparity + begin, disparity + end, std::min(left, right));
    begin = end;
  }
}

void CopyRow(int from, int to, cv::Mat* disparity) {
  const float* source = disparity->ptr<float>(from);
  std::copy(source, source + disparity->cols, disparity->ptr<float>(to));
}

// Fills the stretches of rows that have no valid pixel.
void FillEmptyRows(const cv::Mat& valid, float fallback, cv::Mat* disparity) {
  const int height = disparity->rows;
  for (int begin = 0; begin < height;) {
    if (HasValid(valid, begin)) {
      ++begin;
      continue;
    }
    int end = begin;
    while (end < height && !HasValid(valid, end)) ++end;
    if (begin == 0 && end == height) {
      disparity->setTo(fallback);
      return;
    }
    const int above = begin == 0 ? end : begin - 1;
    const int below = end == height ? begin - 1 : end;
    for (int y = begin; y < end; ++y) {
      CopyRow(std::abs(y - above) <= std::abs(below - y) ? above : below, y, disparity);
    }
    begin = end;
  }
}

}  // namespace

void FillScanlines(const cv::Mat& valid, float fallback, cv::Mat* disparity, ThreadPool* pool) {
  pool->ForRanges(disparity->rows, [&](int begin, int end) {
    for (int y = begin; y < end; ++y) {
      FillRow(valid.ptr<std::uint8_t>(y), disparity->cols, disparity->ptr<float>(y));
    }
  });
  FillEmptyRows(valid, fallback, disparity);
}

}  // namespace stereo_sgmp
