#include "io/prior_picture.h"

#include <cmath>
#include <cstddef>
#include <cstdint>
#include <utility>
#include <vector>

#include <opencv2/imgproc.hpp>

namespace stereo_sgmp {
namespace {

const cv::Vec3b kNoPlane(48, 48, 48);

enum Shade { kDark, kPlain, kBright, kShadeCount };

constexpr int kSaturation[kShadeCount] = {170, 150, 60};
constexpr int kValue[kShadeCount] = {70, 175, 255};

double Hue(std::size_t plane) {
  constexpr double kGoldenRatio = 0.6180339887498949;
  constexpr double kHues = 180.0;  // OpenCV's degrees / 2
  const double turns = kGoldenRatio * static_cast<double>(plane);
  return kHues * (turns - std::floor(turns));
}

// Colours [plane * kShadeCount + shade].
std::vector<cv::Vec3b> PlaneColors(std::size_t planes) {
  cv::Mat_<cv::Vec3b> colors(1, static_cast<int>(planes) * kShadeCount);
  for (int i = 0; i < colors.cols; ++i) {
    colors(i) = cv::Vec3b(static_cast<std::uint8_t>(Hue(static_cast<std::size_t>(i / kShadeCount))),
                          static_cast<std::uint8_t>(kSaturation[i % kShadeCount]),
                          static_cast<std::uint8_t>(kValue[i % kShadeCount]));
  }
  if (!colors.empty()) cv::cvtColor(colors, colors, cv::COLOR_HSV2BGR);
  return {colors.begin(), colors.end()};
}

// j at p for r = (1, 0) or, where that is 0, for r = (0, 1), as a shade.
Shade StepShade(const DisparityPlane& plane, int x, int y) {
  const double here = std::nearbyint(plane.At(x, y));
  const double right = std::nearbyint(plane.At(x + 1, y));
  const double below = std::nearbyint(plane.At(x, y + 1));
  const double jump = right != here ? right - here : below - here;
  if (jump > 0.0) return kBright;
  return jump < 0.0 ? kDark : kPlain;
}

}  // namespace

cv::Mat PriorPicture(const PlanePriors& priors, cv::Size size) {
  cv::Mat_<cv::Vec3b> picture(size, kNoPlane);
  if (priors.labels.empty()) return std::move(picture);
  cv::Mat_<std::int16_t> labels;
  cv::resize(priors.labels, labels, size, 0.0, 0.0, cv::INTER_NEAREST);
  const std::vector<cv::Vec3b> colors = PlaneColors(priors.planes.size());
  for (int y = 0; y < size.height; ++y) {
    for (int x = 0; x < size.width; ++x) {
      if (labels(y, x) < 0) continue;
      const auto label = static_cast<std::size_t>(labels(y, x));
      const Shade shade = StepShade(priors.planes[label].plane, x, y);
      picture(y, x) = colors[label * kShadeCount + shade];
    }
  }
  return std::move(picture);
}

cv::Vec3b PlaneColor(std::size_t index) {
  cv::Mat_<cv::Vec3b> color(1, 1);
  color(0) = cv::Vec3b(static_cast<std::uint8_t>(Hue(index)), kSaturation[kPlain], kValue[kPlain]);
  cv::cvtColor(color, color, cv::COLOR_HSV2BGR);
  return color(0);
}

}  // namespace stereo_sgmp
