#include "prior/confident_pixels.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <stdexcept>

namespace stereo_sgmp {
namespace {

// Sub-pixel offsets reach half a disparity, so both winners are compared as whole disparities.
constexpr int kLeftRightTolerance = 1;

void CheckInputs(const cv::Mat& uncertainty, const cv::Mat& disparity,
                 const cv::Mat& right_winner) {
  if (uncertainty.type() != CV_16UC1 && uncertainty.type() != CV_32FC1) {
    throw std::invalid_argument("The uncertainty has OpenCV type " +
                                std::to_string(uncertainty.type()) +
                                "; expected one channel of CV_16U or CV_32F.");
  }
  if (disparity.type() != CV_32FC1 || right_winner.type() != CV_16UC1) {
    throw std::invalid_argument(
        "Confident pixels need a CV_32F disparity and a CV_16U right winner; convert them first.");
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

}  // namespace

void ConfidentPixels::Select(const cv::Mat& uncertainty, const cv::Mat& disparity,
                             const cv::Mat& right_winner, int min_disparity, double keep_quantile) {
  CheckInputs(uncertainty, disparity, right_winner);
  mask_.create(disparity.size(), CV_8UC1);
  if (mask_.empty()) return;
  uncertainty.convertTo(uncertainty_, CV_32F);
  const float limit = UncertaintyLimit(uncertainty_, keep_quantile);
  for (int y = 0; y < disparity.rows; ++y) {
    const float* u = uncertainty_.ptr<float>(y);
    const float* d = disparity.ptr<float>(y);
    const std::uint16_t* right = right_winner.ptr<std::uint16_t>(y);
    std::uint8_t* mask = mask_.ptr<std::uint8_t>(y);
    for (int x = 0; x < disparity.cols; ++x) {
      const bool confident =
          u[x] <= limit && MatchesRight(d, right, x, disparity.cols, min_disparity);
      mask[x] = confident ? 255 : 0;
    }
  }
}

float ConfidentPixels::UncertaintyLimit(const cv::Mat& uncertainty, double keep_quantile) {
  const float* values = uncertainty.ptr<float>();
  sorted_.assign(values, values + uncertainty.total());
  const double rank = std::clamp(keep_quantile, 0.0, 1.0) * static_cast<double>(sorted_.size());
  const std::size_t index = std::min(sorted_.size() - 1, static_cast<std::size_t>(rank));
  const auto limit = sorted_.begin() + static_cast<std::ptrdiff_t>(index);
  std::nth_element(sorted_.begin(), limit, sorted_.end());
  return *limit;
}

}  // namespace stereo_sgmp
