#ifndef STEREO_SGMP_ROS_SYNCHRONIZER_H_
#define STEREO_SGMP_ROS_SYNCHRONIZER_H_

#include <array>
#include <cstddef>
#include <cstdint>
#include <functional>
#include <memory>
#include <string>

#include <ros/time.h>
#include <sensor_msgs/CameraInfo.h>
#include <sensor_msgs/Image.h>

#include "ros/stereo_frame.h"

namespace stereo_sgmp {

// Puts the messages of the four input topics together by their stamps. Unlike the synchronizers
// of message_filters, on which it builds, it starts afresh when time goes back (a bag that is
// played in a loop) and says why no frame comes out. Not thread safe: all calls come from the
// one callback queue of the nodelet.
class StereoSynchronizer {
 public:
  struct Settings {
    int queue_size = 5;         // messages of a topic that wait for their partners
    bool approximate = false;   // pair the nearest stamps instead of equal ones
    double max_interval = 0.0;  // largest difference of the stamps of a frame, s; 0: no limit
  };
  using FrameCallback = std::function<void(const StereoFrame&)>;
  using ProblemCallback = std::function<void(const std::string& kind, const std::string& text)>;

  // `on_problem` gets a sentence (value, expectation, remedy) and a name for its kind.
  StereoSynchronizer(const Settings& settings, FrameCallback on_frame, ProblemCallback on_problem);
  ~StereoSynchronizer();

  void AddLeftImage(const sensor_msgs::ImageConstPtr& message);
  void AddLeftInfo(const sensor_msgs::CameraInfoConstPtr& message);
  void AddRightImage(const sensor_msgs::ImageConstPtr& message);
  void AddRightInfo(const sensor_msgs::CameraInfoConstPtr& message);

  // Forgets the messages that wait.
  void Reset();

  // Messages since the start: left image, left info, right image, right info.
  static constexpr int kTopics = 4;
  using Counts = std::array<std::uint64_t, kTopics>;
  const Counts& received() const { return received_; }

 private:
  class Policy;

  struct Topic {
    ros::Time newest;  // zero: nothing since the last reset
    int unpaired = 0;  // messages since the last frame
  };

  template <class MessagePtr>
  void Add(std::size_t topic, const MessagePtr& message, void (Policy::*add)(const MessagePtr&));
  void HandleFrame(const sensor_msgs::ImageConstPtr& left,
                   const sensor_msgs::CameraInfoConstPtr& left_info,
                   const sensor_msgs::ImageConstPtr& right,
                   const sensor_msgs::CameraInfoConstPtr& right_info);
  void Note(std::size_t topic, const ros::Time& stamp);
  void ReportIfStuck();
  std::string MissingTopics() const;
  std::string UnequalStamps() const;

  const Settings settings_;
  const FrameCallback on_frame_;
  const ProblemCallback on_problem_;
  std::array<Topic, kTopics> topics_;
  Counts received_{};
  std::unique_ptr<Policy> policy_;
};

}  // namespace stereo_sgmp

#endif  // STEREO_SGMP_ROS_SYNCHRONIZER_H_
