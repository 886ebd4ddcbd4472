#ifndef STEREO_SGMP_ROS_MATCHED_FRAME_H_
#define STEREO_SGMP_ROS_MATCHED_FRAME_H_

#include <std_msgs/Header.h>

#include "stereo_sgmp/match_result.h"
#include "stereo_sgmp/options.h"
#include "stereo_sgmp/stereo_camera.h"

namespace stereo_sgmp {

// A matched frame and what the messages about it need.
struct MatchedFrame {
  const MatchResult& result;
  Options options;
  StereoCamera camera;
  double scale;             // of the images that were matched to those that came, 1 or less
  std_msgs::Header header;  // of the left image
};

}  // namespace stereo_sgmp

#endif  // STEREO_SGMP_ROS_MATCHED_FRAME_H_
