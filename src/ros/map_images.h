// The maps that are published as images.
#ifndef STEREO_SGMP_ROS_MAP_IMAGES_H_
#define STEREO_SGMP_ROS_MAP_IMAGES_H_

#include <array>

#include <opencv2/core.hpp>

#include "ros/matched_frame.h"

namespace stereo_sgmp {

struct MapImage {
  const char* topic;
  const char* encoding;
  cv::Mat (*make)(const MatchedFrame& frame);
};

inline constexpr int kMapImageCount = 7;
const std::array<MapImage, kMapImageCount>& MapImages();

// The filtered disparities in colour, BGR: far blue, near red, invalid dark gray.
cv::Mat DisparityPicture(const MatchedFrame& frame);

}  // namespace stereo_sgmp

#endif  // STEREO_SGMP_ROS_MAP_IMAGES_H_
