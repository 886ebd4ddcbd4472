#ifndef STEREO_SGMP_ROS_TOOLS_PAIR_MESSAGES_H_
#define STEREO_SGMP_ROS_TOOLS_PAIR_MESSAGES_H_

#include <string>
#include <utility>
#include <vector>

#include <sensor_msgs/CameraInfo.h>
#include <sensor_msgs/Image.h>
#include <std_msgs/Header.h>
#include <opencv2/core.hpp>

#include "stereo_sgmp/stereo_camera.h"

namespace stereo_sgmp {

// A rectified pair of pictures, and the camera that took it.
struct Pair {
  cv::Mat left;
  cv::Mat right;
  StereoCamera camera;
};

// Reads two pictures and Middlebury's calib.txt. Throws std::invalid_argument where one is missing,
// can't be read or does not go with the others.
Pair LoadPair(const std::string& left, const std::string& right, const std::string& calib);

// The same from a folder with im0.png, im1.png and calib.txt.
Pair LoadPair(const std::string& scene);

// What a stereo camera publishes, each with its topic within the camera's namespace.
struct PairMessages {
  std::vector<std::pair<std::string, sensor_msgs::Image>> images;
  std::vector<std::pair<std::string, sensor_msgs::CameraInfo>> infos;
};

// image_rect and camera_info of both sides, left/image_rect_color where the pictures have colour,
// and image_raw if `raw`.
PairMessages MakeMessages(const Pair& pair, const std_msgs::Header& header, bool raw);

}  // namespace stereo_sgmp

#endif  // STEREO_SGMP_ROS_TOOLS_PAIR_MESSAGES_H_
