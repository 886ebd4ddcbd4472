#include "matcher/load_level.h"

#include <algorithm>
#include <cmath>

namespace stereo_sgmp {
namespace {

// How much smaller the images are along each axis, after rounding to whole pixels.
struct Scale {
  Scale(cv::Size size, const LoadLevel& level)
      : x(static_cast<double>(SizeAtLevel(size, level).width) / size.width),
        y(static_cast<double>(SizeAtLevel(size, level).height) / size.height) {}

  double x;
  double y;
};

double ScaledCenter(double center, double scale) { return (center + 0.5) * scale - 0.5; }

}  // namespace

const std::vector<LoadLevel>& LoadLevels() {
  static const std::vector<LoadLevel> kLevels{{"nothing", 1.0, true, true, 1.0},
                                              {"slow refinement", 1.0, false, true, 1.2},
                                              {"half of the paths", 1.0, false, false, 1.15},
                                              {"resolution: 3/4", 0.75, false, false, 1.15},
                                              {"resolution: 1/2", 0.5, false, false, 1.7},
                                              {"resolution: 1/3", 1.0 / 3.0, false, false, 1.2},
                                              {"resolution: 1/4", 0.25, false, false, 1.3}};
  return kLevels;
}

cv::Size SizeAtLevel(cv::Size size, const LoadLevel& level) {
  const auto scaled = [&](int length) {
    return std::max(1, static_cast<int>(std::lround(length * level.scale)));
  };
  return {scaled(size.width), scaled(size.height)};
}

Options OptionsAtLevel(const Options& options, cv::Size size, const LoadLevel& level) {
  Options lowered = options;
  if (!level.thorough) {
    RefinementOptions& refinement = lowered.refinement;
    refinement.median = refinement.median || refinement.weighted_median;
    refinement.weighted_median = false;
    refinement.plane_propagation = false;
    refinement.plane_smoothing = false;
    refinement.superpixel_planes = false;
  }
  if (!level.all_paths) lowered.aggregation.scheme = PathScheme::kFour;
  const Scale scale(size, level);
  const int last = options.min_disparity + options.num_disparities - 1;
  lowered.min_disparity = static_cast<int>(std::floor(options.min_disparity * scale.x));
  lowered.num_disparities = static_cast<int>(std::ceil(last * scale.x)) - lowered.min_disparity + 1;
  lowered.num_disparities = std::min(lowered.num_disparities, SizeAtLevel(size, level).width);
  lowered.filter.speckle_size =
      static_cast<int>(std::lround(options.filter.speckle_size * scale.x * scale.y));
  return lowered;
}

StereoCamera CameraAtLevel(const StereoCamera& camera, cv::Size size, const LoadLevel& level) {
  const Scale scale(size, level);
  StereoCamera lowered = camera;
  lowered.focal_length *= scale.x;
  lowered.cx = ScaledCenter(camera.cx, scale.x);
  lowered.cy = ScaledCenter(camera.cy, scale.y);
  lowered.doffs *= scale.x;
  return lowered;
}

}  // namespace stereo_sgmp
