#include "evaluation/error_map.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>

namespace stereo_sgmp {
namespace {

// Blue, green, red.
const cv::Vec3b kCorrect(205, 205, 205);
const cv::Vec3b kMissing(200, 90, 40);
const cv::Vec3b kNotEvaluated(28, 28, 28);

constexpr double kDoublings = 4.0;  // from the first to the last colour

cv::Vec3b ColorOfExcess(double doublings) {
  static const std::array<cv::Vec3d, 3> kColors = {
      {{50.0, 225.0, 255.0}, {20.0, 110.0, 240.0}, {10.0, 0.0, 110.0}}};
  const double at = std::clamp(doublings / kDoublings, 0.0, 1.0) * (kColors.size() - 1);
  const std::size_t first = std::min(static_cast<std::size_t>(at), kColors.size() - 2);
  const double part = at - static_cast<double>(first);
  const cv::Vec3d color = kColors[first] * (1.0 - part) + kColors[first + 1] * part;
  return {cv::saturate_cast<std::uint8_t>(color[0]), cv::saturate_cast<std::uint8_t>(color[1]),
          cv::saturate_cast<std::uint8_t>(color[2])};
}

}  // namespace

cv::Mat ErrorMap(const cv::Mat& disparity, const cv::Mat& truth, const cv::Mat& evaluated,
                 const ErrorBound& bound) {
  const cv::Mat bad = BadPixels(disparity, truth, evaluated, bound);
  cv::Mat picture(truth.size(), CV_8UC3, kNotEvaluated);
  picture.setTo(kCorrect, evaluated);
  for (int y = 0; y < bad.rows; ++y) {
    for (int x = 0; x < bad.cols; ++x) {
      if (bad.at<std::uint8_t>(y, x) == 0) continue;
      const float d = disparity.at<float>(y, x);
      const double t = truth.at<float>(y, x);
      const double limit = std::max(bound.pixels, bound.share * std::abs(t));
      picture.at<cv::Vec3b>(y, x) =
          std::isfinite(d) ? ColorOfExcess(std::log2(std::abs(d - t) / limit)) : kMissing;
    }
  }
  return picture;
}

}  // namespace stereo_sgmp
