#include "evaluation/disparity_range.h"

#include <algorithm>
#include <cmath>

#include <opencv2/core.hpp>

#include "evaluation/metrics.h"

namespace stereo_sgmp {

int DisparitiesToSearch(const StereoScene& scene, const Options& options) {
  if (scene.calibration && scene.calibration->num_disparities > 0) {
    return scene.calibration->num_disparities;
  }
  constexpr double kMargin = 1.1;
  int count = options.num_disparities;
  const cv::Mat known = EvaluatedPixels(scene.disparity, cv::Mat());
  if (cv::countNonZero(known) > 0) {
    double largest = 0.0;
    cv::minMaxLoc(scene.disparity, nullptr, &largest, nullptr, nullptr, known);
    largest = std::min<double>(kMargin * largest, scene.left.cols);
    count = std::max(static_cast<int>(std::ceil(largest)) + 1 - options.min_disparity, 1);
  }
  return std::min(count, scene.left.cols);
}

}  // namespace stereo_sgmp
