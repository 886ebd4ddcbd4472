#include "prior/confident_pixels.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <stdexcept>

#include "common/byte_counts.h"

namespace stereo_sgmp {
namespace {

// Sub-pixel offsets reach half a disparity, so both winners are compared as whole disparities.
constexpr int kLeftRightTolerance = 1;

void CheckInputs(const cv::Mat& uncertainty, const cv::Mat& disparity,
                 const cv::Mat& right_winner) {
  if (uncertainty.type() != CV_16UC1 || disparity.type() != CV_32FC1 ||
      right_winner.type() != CV_16UC1) {
    throw std::invalid_argument(
        "Confident pixels need a CV_16U uncertainty, a CV_32F disparity and a CV_16U right winner; "
        "convert them first.");
  }
  if (uncertainty.size() != disparity.size() || right_winner.size() != disparity.size()) {
    throw std::invalid_argument(
        "Uncertainty, disparity and right winner differ in size; pass maps of one pass.");
  }
}

bool MatchesRight(const float* disparity, const std::uint16_t* right, int x, int width,
                  int min_disparity) {
  if (!std::isfinite(disparity[x])) return false;
  const int d = cvRound(disparity[x]);
  const int x_right = x - d;
  if (x_right < 0 || x_right >= width) return false;
  return std::abs(right[x_right] + min_disparity - d) <= kLeftRightTolerance;
}

template <class Body>
void ForEachValue(const cv::Mat& image, const Body& body) {
  for (int y = 0; y < image.rows; ++y) {
    const std::uint16_t* row = image.ptr<std::uint16_t>(y);
    for (int x = 0; x < image.cols; ++x) body(row[x]);
  }
}

// The value that the share `keep_quantile` of all comes before.
int UncertaintyLimit(const cv::Mat& uncertainty, double keep_quantile) {
  const double share = std::clamp(keep_quantile, 0.0, 1.0);
  const auto wanted = static_cast<std::size_t>(share * static_cast<double>(uncertainty.total()));
  std::size_t rank = std::min(uncertainty.total() - 1, wanted);
  ByteCounts high_counts;
  ForEachValue(uncertainty, [&](int value) { high_counts.Add(value >> 8); });
  const int high = high_counts.Find(&rank);
  ByteCounts low_counts;
  ForEachValue(uncertainty, [&](int value) {
    if (value >> 8 == high) low_counts.Add(value & 0xFF);
  });
  return high << 8 | low_counts.Find(&rank);
}

}  // namespace

void ConfidentPixels::Select(const cv::Mat& uncertainty, const cv::Mat& disparity,
                             const cv::Mat& right_winner, int min_disparity, double keep_quantile,
                             ThreadPool* threads) {
  CheckInputs(uncertainty, disparity, right_winner);
  mask_.create(disparity.size(), CV_8UC1);
  if (mask_.empty()) return;
  const int limit = UncertaintyLimit(uncertainty, keep_quantile);
  const auto select_rows = [&](int begin, int end) {
    for (int y = begin; y < end; ++y) {
      const std::uint16_t* u = uncertainty.ptr<std::uint16_t>(y);
      const float* d = disparity.ptr<float>(y);
      const std::uint16_t* right = right_winner.ptr<std::uint16_t>(y);
      std::uint8_t* mask = mask_.ptr<std::uint8_t>(y);
      for (int x = 0; x < disparity.cols; ++x) {
        const bool confident =
            u[x] <= limit && MatchesRight(d, right, x, disparity.cols, min_disparity);
        mask[x] = confident ? 255 : 0;
      }
    }
  };
  if (threads != nullptr) {
    threads->ForRanges(disparity.rows, select_rows);
  } else {
    select_rows(0, disparity.rows);
  }
}

}  // namespace stereo_sgmp
