#ifndef STEREO_SGMP_ROS_COLOR_IMAGES_H_
#define STEREO_SGMP_ROS_COLOR_IMAGES_H_

#include <chrono>
#include <condition_variable>
#include <cstddef>
#include <deque>
#include <mutex>

#include <ros/time.h>
#include <sensor_msgs/Image.h>

namespace stereo_sgmp {

// The last colour images, to be found by their stamp when a cloud is to be coloured. Safe to call
// from several threads.
class ColorImages {
 public:
  explicit ColorImages(std::size_t capacity) : capacity_(capacity) {}

  void Add(const sensor_msgs::ImageConstPtr& image);
  void Clear();

  // Null when there is none of this stamp.
  sensor_msgs::ImageConstPtr Find(const ros::Time& stamp) const;

  // As Find, but where colour images keep coming, waits for `patience` at most for one that is
  // later than the gray ones.
  sensor_msgs::ImageConstPtr WaitFor(const ros::Time& stamp,
                                     std::chrono::milliseconds patience) const;

 private:
  sensor_msgs::ImageConstPtr FindLocked(const ros::Time& stamp) const;
  // Whether one of `stamp` may still come: the last one is of a moment before.
  bool MayCome(const ros::Time& stamp) const;

  const std::size_t capacity_;
  mutable std::mutex mutex_;  // guards the images
  mutable std::condition_variable added_;
  std::deque<sensor_msgs::ImageConstPtr> images_;  // oldest first
};

}  // namespace stereo_sgmp

#endif  // STEREO_SGMP_ROS_COLOR_IMAGES_H_
