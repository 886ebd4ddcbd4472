#ifndef STEREO_SGMP_ROS_COLOR_IMAGES_H_
#define STEREO_SGMP_ROS_COLOR_IMAGES_H_

#include <cstddef>
#include <deque>
#include <mutex>

#include <ros/time.h>
#include <sensor_msgs/Image.h>

namespace stereo_sgmp {

// The last colour images, to be found by their stamp when a cloud is to be coloured: nothing
// ever waits for them. Safe to call from several threads.
class ColorImages {
 public:
  explicit ColorImages(std::size_t capacity) : capacity_(capacity) {}

  void Add(const sensor_msgs::ImageConstPtr& image);
  void Clear();

  // Null when there is none of this stamp.
  sensor_msgs::ImageConstPtr Find(const ros::Time& stamp) const;

 private:
  const std::size_t capacity_;
  mutable std::mutex mutex_;
  std::deque<sensor_msgs::ImageConstPtr> images_;  // oldest first
};

}  // namespace stereo_sgmp

#endif  // STEREO_SGMP_ROS_COLOR_IMAGES_H_
