#include "io/color_map.h"

#include <algorithm>
#include <limits>

#include <opencv2/imgproc.hpp>

namespace stereo_sgmp {
namespace {

cv::Mat ApplyColors(const cv::Mat& values, double min, double max, cv::ColormapTypes map) {
  const double scale = 255.0 / std::max(max - min, std::numeric_limits<double>::min());
  cv::Mat levels;
  values.convertTo(levels, CV_8U, scale, -min * scale);
  cv::Mat colors;
  cv::applyColorMap(levels, colors, map);
  return colors;
}

}  // namespace

cv::Mat ColorDisparity(const cv::Mat& disparity, double min, double max) {
  const cv::Scalar invalid_color(48, 48, 48);
  const cv::Mat finite = cv::abs(disparity) <= std::numeric_limits<float>::max();
  cv::Mat values = disparity.clone();
  values.setTo(min, ~finite);
  cv::Mat colors = ApplyColors(values, min, max, cv::COLORMAP_TURBO);
  colors.setTo(invalid_color, ~finite);
  return colors;
}

cv::Mat ColorConfidence(const cv::Mat& confidence) {
  return ApplyColors(confidence, 0.0, 1.0, cv::COLORMAP_VIRIDIS);
}

}  // namespace stereo_sgmp
