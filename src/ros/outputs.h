#ifndef STEREO_SGMP_ROS_OUTPUTS_H_
#define STEREO_SGMP_ROS_OUTPUTS_H_

#include <cstdint>
#include <functional>

#include <image_transport/image_transport.h>
#include <ros/node_handle.h>
#include <ros/publisher.h>
#include <std_msgs/Header.h>
#include <opencv2/core.hpp>

#include "stereo_sgmp/match_result.h"
#include "stereo_sgmp/options.h"
#include "stereo_sgmp/point_cloud.h"
#include "stereo_sgmp/stereo_camera.h"

namespace stereo_sgmp {

// A matched frame and what the messages about it need.
struct MatchedFrame {
  const MatchResult& result;
  const Options& options;
  const StereoCamera& camera;
  std_msgs::Header header;  // of the left image
};

// Frames since the start.
struct FrameCounts {
  std::uint64_t matched = 0;
  std::uint64_t dropped = 0;
  std::uint64_t rejected = 0;
};

// The topics that the nodelet publishes; each message is made only when somebody listens.
class Outputs {
 public:
  // `on_change` is called for each listener that comes or goes, possibly before this returns and
  // from another thread.
  void Advertise(ros::NodeHandle& nh, const std::function<void()>& on_change);

  // Waits for calls of `on_change` that run; afterwards there are none, and nothing to publish on.
  void Shutdown();

  bool AnyWanted() const;
  bool CloudWanted() const { return cloud_.getNumSubscribers() > 0; }

  // Everything but the cloud and the statistics.
  void PublishMaps(const MatchedFrame& frame);

  // Coloured by `image`, of the size of the left one: 8 or 16 bit, gray, BGR or BGRA.
  void PublishCloud(const MatchedFrame& frame, const cv::Mat& image);

  void PublishStatistics(const MatchedFrame& frame, double latency_ms, const FrameCounts& counts);

 private:
  ros::Publisher disparity_;
  ros::Publisher cloud_;
  ros::Publisher priors_;
  ros::Publisher statistics_;
  image_transport::Publisher confidence_;
  image_transport::Publisher disparity_color_;
  image_transport::Publisher priors_color_;
  PointCloud points_;  // kept for its memory
};

}  // namespace stereo_sgmp

#endif  // STEREO_SGMP_ROS_OUTPUTS_H_
