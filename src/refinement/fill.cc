#include "refinement/fill.h"

#include <algorithm>
#include <atomic>
#include <cstddef>
#include <cstdint>
#include <cstdlib>
#include <cstring>

namespace stereo_sgmp {
namespace {

constexpr auto kIsValid = [](std::uint8_t valid) { return valid != 0; };

bool HasValid(const cv::Mat& valid, int y) {
  const std::uint8_t* row = valid.ptr<std::uint8_t>(y);
  return std::any_of(row, row + valid.cols, kIsValid);
}

// Leaves a row without a valid pixel as it is, and says whether it has one.
bool FillRow(const std::uint8_t* valid, int width, float* disparity) {
  const std::uint8_t* const valid_end = valid + width;
  for (int begin = 0; begin < width;) {
    const auto rest = static_cast<std::size_t>(width - begin);
    const void* const hole = std::memchr(valid + begin, 0, rest);
    if (hole == nullptr) break;
    begin = static_cast<int>(static_cast<const std::uint8_t*>(hole) - valid);
    const int end = static_cast<int>(std::find_if(valid + begin, valid_end, kIsValid) - valid);
    if (begin == 0 && end == width) return false;
    const float left = disparity[begin == 0 ? end : begin - 1];
    const float right = disparity[end == width ? begin - 1 : end];
    std::fill(disparity + begin, disparity + end, std::min(left, right));
    begin = end;
  }
  return true;
}

void CopyRow(int from, int to, cv::Mat* disparity) {
  const float* source = disparity->ptr<float>(from);
  std::copy(source, source + disparity->cols, disparity->ptr<float>(to));
}

}  // namespace

bool FillRows(const cv::Mat& valid, int begin, int end, cv::Mat* disparity) {
  bool all = true;
  for (int y = begin; y < end; ++y) {
    all &= FillRow(valid.ptr<std::uint8_t>(y), disparity->cols, disparity->ptr<float>(y));
  }
  return all;
}

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

void FillScanlines(const cv::Mat& valid, float fallback, cv::Mat* disparity, ThreadPool* pool) {
  std::atomic<bool> all{true};
  pool->ForRanges(disparity->rows, [&](int begin, int end) {
    if (!FillRows(valid, begin, end, disparity)) all = false;
  });
  if (!all) FillEmptyRows(valid, fallback, disparity);
}

}  // namespace stereo_sgmp
