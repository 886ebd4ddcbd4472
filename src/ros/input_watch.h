#ifndef STEREO_SGMP_ROS_INPUT_WATCH_H_
#define STEREO_SGMP_ROS_INPUT_WATCH_H_

#include <cstdint>
#include <string>
#include <vector>

#include <ros/time.h>

namespace stereo_sgmp {

// A topic that the nodelet subscribes to.
struct InputTopic {
  std::string name;              // resolved
  std::string type;              // such as sensor_msgs/Image
  std::uint64_t received = 0;    // messages since the start
  std::uint32_t publishers = 0;  // connected
};

// A topic that somebody publishes, as the master lists it.
struct PublishedTopic {
  std::string name;
  std::string type;
};

// What to do about inputs on which nothing arrives: who should publish, or which published topic
// might be meant.
std::string SilenceAdvice(const std::vector<InputTopic>& inputs,
                          const std::vector<PublishedTopic>& published);

// Notices when none of the inputs receives anything.
class InputWatch {
 public:
  // Forgets what was: for when the nodelet subscribes.
  void Reset();

  // To be called about once a second; true when nothing has arrived for a while, and again after
  // each such while.
  bool IsSilent(const std::vector<InputTopic>& inputs, const ros::WallTime& now);

 private:
  std::uint64_t received_ = 0;
  ros::WallTime since_;  // zero: not yet called
};

}  // namespace stereo_sgmp

#endif  // STEREO_SGMP_ROS_INPUT_WATCH_H_
