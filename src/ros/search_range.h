#ifndef STEREO_SGMP_ROS_SEARCH_RANGE_H_
#define STEREO_SGMP_ROS_SEARCH_RANGE_H_

#include <string>

#include "ros/stream_options.h"
#include "stereo_sgmp/options.h"
#include "stereo_sgmp/stereo_camera.h"

namespace stereo_sgmp {

struct SearchRange {
  Options options;      // of the matcher, with the range that was asked for in metres
  std::string problem;  // a sentence where not all of it can be searched; else empty
};

// The options for images of `width` columns. Where min_depth or max_depth is set, it takes the
// place of num_disparities or min_disparity.
SearchRange ResolveSearchRange(const NodeletOptions& options, const StereoCamera& camera,
                               int width);

}  // namespace stereo_sgmp

#endif  // STEREO_SGMP_ROS_SEARCH_RANGE_H_
