#ifndef STEREO_SGMP_ROS_CAMERA_MODEL_H_
#define STEREO_SGMP_ROS_CAMERA_MODEL_H_

#include <string>

#include <sensor_msgs/CameraInfo.h>
#include <opencv2/core.hpp>

#include "stereo_sgmp/stereo_camera.h"

namespace stereo_sgmp {

// The rectified camera that a pair of camera_info messages describes, for images of `image_size`;
// baseline in metres. Binning and the region of interest of the messages are taken into account.
// Throws std::invalid_argument naming the value, what is expected and the remedy when the
// messages can't belong to a calibrated, rectified pair of such images.
StereoCamera CameraFromInfo(const sensor_msgs::CameraInfo& left,
                            const sensor_msgs::CameraInfo& right, cv::Size image_size);

// What is wrong with the frame ids of a pair, as a sentence; empty when they agree. By
// convention both messages of a rectified pair carry the left camera's optical frame.
std::string FrameIdProblem(const sensor_msgs::CameraInfo& left,
                           const sensor_msgs::CameraInfo& right);

}  // namespace stereo_sgmp

#endif  // STEREO_SGMP_ROS_CAMERA_MODEL_H_
