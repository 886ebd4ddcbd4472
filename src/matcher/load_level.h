// What is given up, step by step, to match in less time.
#ifndef STEREO_SGMP_MATCHER_LOAD_LEVEL_H_
#define STEREO_SGMP_MATCHER_LOAD_LEVEL_H_

#include <vector>

#include <opencv2/core.hpp>

#include "stereo_sgmp/options.h"
#include "stereo_sgmp/stereo_camera.h"

namespace stereo_sgmp {

struct LoadLevel {
  const char* name;         // what is given up, for people
  double scale;             // of the images that are matched
  bool thorough;            // with the slow steps of refinement, where the options ask for them
  bool all_paths;           // with the scheme of paths that the options ask for
  double cost_of_previous;  // at least so many times the time of this level
};

// From nothing given up on, in the order in which it is: the slow steps of refinement, then the
// paths but for the four along the axes, which saves as much time as 3/4 of the resolution and
// costs less accuracy, then resolution to 3/4, 1/2, 1/3 and 1/4. Disparities shrink with the
// images, so that the depths that are searched stay the same: what is near a robot is never
// dropped.
const std::vector<LoadLevel>& LoadLevels();

cv::Size SizeAtLevel(cv::Size size, const LoadLevel& level);

// The options and the camera for images of SizeAtLevel(size, level) in place of `size`.
Options OptionsAtLevel(const Options& options, cv::Size size, const LoadLevel& level);
StereoCamera CameraAtLevel(const StereoCamera& camera, cv::Size size, const LoadLevel& level);

}  // namespace stereo_sgmp

#endif  // STEREO_SGMP_MATCHER_LOAD_LEVEL_H_
