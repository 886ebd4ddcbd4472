// ROS parameters and dynamic_reconfigure <-> Options, field by field through VisitNodeletOptions.
#ifndef STEREO_SGMP_ROS_PARAMETERS_H_
#define STEREO_SGMP_ROS_PARAMETERS_H_

#include <functional>
#include <string>

#include <ros/node_handle.h>
#include <stereo_sgmp/StereoSgmpConfig.h>

#include "ros/stream_options.h"
#include "ros/synchronizer.h"

namespace stereo_sgmp {

// What can't change while the nodelet runs: queue_size, approximate_sync and
// approximate_max_interval.
StereoSynchronizer::Settings ReadSynchronizerSettings(
    const ros::NodeHandle& private_nh, const std::function<void(const std::string&)>& report);

// The options that the parameters ask for. Later ones win: the preset (`preset`), options named
// as in dynamic_reconfigure (`prior_variant`), stereo_image_proc's names where they mean the
// same, and options named as in YAML files (`prior/variant`): dynamic_reconfigure leaves its
// values on the parameter server, where they outlive the nodelet. A value of the wrong type, or a
// variant that needs more than images and their camera, keeps what was there, one out of range is
// clamped, and all are reported. Does not throw.
NodeletOptions ReadOptions(const ros::NodeHandle& private_nh,
                           const std::function<void(const std::string&)>& report);

// The name of an option in dynamic_reconfigure: "prior/variant" is prior_variant.
std::string ConfigName(const std::string& field_name);

StereoSgmpConfig ToConfig(const NodeletOptions& options);

// Throws std::invalid_argument naming option, value and expectation when the options are no
// valid ones, or need more than images and their camera.
NodeletOptions FromConfig(const StereoSgmpConfig& config);

}  // namespace stereo_sgmp

#endif  // STEREO_SGMP_ROS_PARAMETERS_H_
