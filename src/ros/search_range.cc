#include "ros/search_range.h"

#include <algorithm>
#include <limits>
#include <sstream>

#include "stereo_sgmp/depth.h"

namespace stereo_sgmp {
namespace {

// What the matcher takes, see stereo_sgmp/option_fields.h.
constexpr int kMostDisparities = 2048;
constexpr int kLargestMinDisparity = 4096;

}  // namespace

SearchRange ResolveSearchRange(const NodeletOptions& options, const StereoCamera& camera,
                               int width) {
  SearchRange range{options.match, ""};
  const double nearest = options.stream.min_depth;
  const double farthest = options.stream.max_depth;
  if (nearest == 0.0 && farthest == 0.0) return range;

  constexpr double kInfinity = std::numeric_limits<double>::infinity();
  Options& match = range.options;
  if (nearest == 0.0) {
    match.min_disparity = RangeOfDepths(camera, farthest / 2.0, farthest).first;
  } else {
    const DisparityRange wanted =
        RangeOfDepths(camera, nearest, farthest > 0.0 ? farthest : kInfinity);
    match.min_disparity = wanted.first;
    match.num_disparities = wanted.count;
  }
  match.min_disparity =
      std::clamp(match.min_disparity, -kLargestMinDisparity, kLargestMinDisparity);
  const int most = std::min(kMostDisparities, width);
  if (match.num_disparities > most) {
    std::ostringstream text;
    text << "min_depth " << nearest << " m takes " << match.num_disparities
         << " disparities; expected at most " << most;
    match.num_disparities = most;
    text << "; the nearest depth is "
         << camera.DepthOf(match.min_disparity + match.num_disparities - 1)
         << " m; raise min_depth, or lower max_depth or the resolution";
    range.problem = text.str();
  }
  return range;
}

}  // namespace stereo_sgmp
