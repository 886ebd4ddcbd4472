// Images of messages as the matcher takes them.
#ifndef STEREO_SGMP_ROS_INPUT_IMAGES_H_
#define STEREO_SGMP_ROS_INPUT_IMAGES_H_

#include <cv_bridge/cv_bridge.h>
#include <sensor_msgs/Image.h>

namespace stereo_sgmp {

// Gray (8 or 16 bit), BGR or BGRA pixels of a message, shared with it unless they have to be
// converted. Throws std::invalid_argument that names `topic`, value and expectation for another
// encoding, an image without pixels or data that do not fill it.
cv_bridge::CvImageConstPtr ToImage(const sensor_msgs::ImageConstPtr& message, const char* topic);

struct InputPair {
  cv_bridge::CvImageConstPtr left;
  cv_bridge::CvImageConstPtr right;
};

// Both images of a pair, of one size and one type; where the encodings differ, both in 8-bit
// gray. Throws as ToImage, and when the sizes differ.
InputPair ToInputPair(const sensor_msgs::ImageConstPtr& left,
                      const sensor_msgs::ImageConstPtr& right);

}  // namespace stereo_sgmp

#endif  // STEREO_SGMP_ROS_INPUT_IMAGES_H_
