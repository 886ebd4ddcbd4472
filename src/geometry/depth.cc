#include "stereo_sgmp/depth.h"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <limits>
#include <sstream>
#include <stdexcept>

namespace stereo_sgmp {
namespace {

// Beyond what any image is wide; keeps the whole numbers below within their type.
constexpr double kLargestDisparity = 1e6;

int WholeDisparity(double disparity) {
  return static_cast<int>(std::clamp(disparity, -kLargestDisparity, kLargestDisparity));
}

}  // namespace

void ComputeDepth(const MatchResult& result, const StereoCamera& camera, cv::Mat* depth) {
  camera.Check();
  depth->create(result.dense.size(), CV_32F);
  const float scale = static_cast<float>(camera.focal_length * camera.baseline);
  const float doffs = static_cast<float>(camera.doffs);
  for (int y = 0; y < depth->rows; ++y) {
    const float* disparity = result.dense.ptr<float>(y);
    const std::uint8_t* reason = result.reason.ptr<std::uint8_t>(y);
    float* out = depth->ptr<float>(y);
    for (int x = 0; x < depth->cols; ++x) {
      const float shifted = disparity[x] + doffs;
      const bool seen =
          reason[x] == static_cast<std::uint8_t>(InvalidReason::kValid) && shifted > 0.0f;
      out[x] = seen ? scale / shifted : std::numeric_limits<float>::quiet_NaN();
    }
  }
}

DisparityRange RangeOfDepths(const StereoCamera& camera, double nearest, double farthest) {
  camera.Check();
  if (!(nearest > 0.0 && nearest < farthest)) {
    std::ostringstream text;
    text << "the depths to search are " << nearest << " to " << farthest
         << "; expected 0 < nearest < farthest";
    throw std::invalid_argument(text.str());
  }
  const int first = WholeDisparity(std::floor(camera.DisparityOf(farthest)));
  const int last = WholeDisparity(std::ceil(camera.DisparityOf(nearest)));
  return {first, last - first + 1};
}

}  // namespace stereo_sgmp
