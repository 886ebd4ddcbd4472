#ifndef STEREO_SGMP_ROS_OUTPUTS_H_
#define STEREO_SGMP_ROS_OUTPUTS_H_

#include <array>
#include <functional>

#include <image_transport/image_transport.h>
#include <ros/node_handle.h>
#include <ros/publisher.h>
#include <sensor_msgs/PointCloud2.h>
#include <stereo_msgs/DisparityImage.h>
#include <opencv2/core.hpp>

#include "ros/map_images.h"
#include "ros/matched_frame.h"
#include "ros/message_pool.h"
#include "ros/stream_options.h"
#include "stereo_sgmp/Statistics.h"
#include "stereo_sgmp/point_cloud.h"

namespace stereo_sgmp {

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
  bool BaselineWanted() const {
    return baseline_.getNumSubscribers() > 0 || baseline_color_.getNumSubscribers() > 0;
  }

  // Everything but the cloud, the baseline and the statistics.
  void PublishMaps(const MatchedFrame& frame);

  // Coloured by `image`, of the size of the left one: 8 or 16 bit, gray, BGR or BGRA. May run
  // beside the others, but not beside itself.
  void PublishCloud(const MatchedFrame& frame, const cv::Mat& image,
                    const CloudStreamOptions& options);

  // The same frame matched without prior.
  void PublishBaseline(const MatchedFrame& frame) const;

  void PublishStatistics(const stereo_sgmp::StatisticsConstPtr& message) const;

 private:
  ros::Publisher disparity_;
  ros::Publisher cloud_;
  ros::Publisher priors_;
  ros::Publisher markers_;
  ros::Publisher baseline_;
  ros::Publisher statistics_;
  image_transport::Publisher baseline_color_;
  std::array<image_transport::Publisher, kMapImageCount> images_;  // as MapImages()
  MessagePool<stereo_msgs::DisparityImage> disparities_;
  MessagePool<sensor_msgs::PointCloud2> clouds_;
  PointCloud points_;  // kept for its memory
};

}  // namespace stereo_sgmp

#endif  // STEREO_SGMP_ROS_OUTPUTS_H_
