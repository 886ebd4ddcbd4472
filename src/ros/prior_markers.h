#ifndef STEREO_SGMP_ROS_PRIOR_MARKERS_H_
#define STEREO_SGMP_ROS_PRIOR_MARKERS_H_

#include <std_msgs/Header.h>
#include <visualization_msgs/MarkerArray.h>
#include <opencv2/core.hpp>

#include "stereo_sgmp/match_result.h"
#include "stereo_sgmp/stereo_camera.h"

namespace stereo_sgmp {

// The planes of a prior as translucent polygons in space and their outlines, cut off beyond
// `max_depth`, in the colours of the prior's picture. Two markers, which the next message
// replaces; without planes it deletes them.
visualization_msgs::MarkerArrayPtr ToPriorMarkers(const PlanePriors& priors, cv::Size image_size,
                                                  const StereoCamera& camera, double max_depth,
                                                  const std_msgs::Header& header);

}  // namespace stereo_sgmp

#endif  // STEREO_SGMP_ROS_PRIOR_MARKERS_H_
