#include "ros/color_images.h"

#include <algorithm>

namespace stereo_sgmp {
namespace {

// Of the stamps of the last colour image and of one that is waited for: after longer ones, the
// camera sends no colour any more.
constexpr double kLongestGap = 1.0;  // seconds

}  // namespace

void ColorImages::Add(const sensor_msgs::ImageConstPtr& image) {
  {
    std::lock_guard<std::mutex> lock(mutex_);
    images_.push_back(image);
    if (images_.size() > capacity_) images_.pop_front();
  }
  added_.notify_all();
}

void ColorImages::Clear() {
  std::lock_guard<std::mutex> lock(mutex_);
  images_.clear();
}

sensor_msgs::ImageConstPtr ColorImages::Find(const ros::Time& stamp) const {
  std::lock_guard<std::mutex> lock(mutex_);
  return FindLocked(stamp);
}

sensor_msgs::ImageConstPtr ColorImages::WaitFor(const ros::Time& stamp,
                                                std::chrono::milliseconds patience) const {
  const auto end = std::chrono::steady_clock::now() + patience;
  std::unique_lock<std::mutex> lock(mutex_);
  sensor_msgs::ImageConstPtr image = FindLocked(stamp);
  while (!image && MayCome(stamp) && added_.wait_until(lock, end) != std::cv_status::timeout) {
    image = FindLocked(stamp);
  }
  return image;
}

sensor_msgs::ImageConstPtr ColorImages::FindLocked(const ros::Time& stamp) const {
  // The newest one first: stamps repeat when a bag is played in a loop.
  const auto found = std::find_if(images_.rbegin(), images_.rend(),
                                  [&](const auto& image) { return image->header.stamp == stamp; });
  return found == images_.rend() ? nullptr : *found;
}

bool ColorImages::MayCome(const ros::Time& stamp) const {
  if (images_.empty()) return false;
  const ros::Time& last = images_.back()->header.stamp;
  // As numbers: a ros::Duration does not hold every difference of two stamps.
  return last < stamp && stamp.toSec() - last.toSec() <= kLongestGap;
}

}  // namespace stereo_sgmp
