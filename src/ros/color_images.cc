#include "ros/color_images.h"

#include <algorithm>

namespace stereo_sgmp {

void ColorImages::Add(const sensor_msgs::ImageConstPtr& image) {
  std::lock_guard<std::mutex> lock(mutex_);
  images_.push_back(image);
  if (images_.size() > capacity_) images_.pop_front();
}

void ColorImages::Clear() {
  std::lock_guard<std::mutex> lock(mutex_);
  images_.clear();
}

sensor_msgs::ImageConstPtr ColorImages::Find(const ros::Time& stamp) const {
  std::lock_guard<std::mutex> lock(mutex_);
  // The newest one first: stamps repeat when a bag is played in a loop.
  const auto found = std::find_if(images_.rbegin(), images_.rend(),
                                  [&](const auto& image) { return image->header.stamp == stamp; });
  return found == images_.rend() ? nullptr : *found;
}

}  // namespace stereo_sgmp
