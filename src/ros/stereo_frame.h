#ifndef STEREO_SGMP_ROS_STEREO_FRAME_H_
#define STEREO_SGMP_ROS_STEREO_FRAME_H_

#include <ros/time.h>
#include <sensor_msgs/CameraInfo.h>
#include <sensor_msgs/Image.h>

namespace stereo_sgmp {

// The messages that belong together: one exposure of both cameras.
struct StereoFrame {
  sensor_msgs::ImageConstPtr left;
  sensor_msgs::CameraInfoConstPtr left_info;
  sensor_msgs::ImageConstPtr right;
  sensor_msgs::CameraInfoConstPtr right_info;
  ros::WallTime arrival;  // when the last of them came
};

}  // namespace stereo_sgmp

#endif  // STEREO_SGMP_ROS_STEREO_FRAME_H_
