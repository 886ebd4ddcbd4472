#include "ros/outputs.h"

#include <sensor_msgs/image_encodings.h>

#include "io/prior_picture.h"
#include "ros/conversions.h"

namespace stereo_sgmp {

namespace enc = sensor_msgs::image_encodings;

void Outputs::Advertise(ros::NodeHandle& nh, const std::function<void()>& on_change) {
  const ros::SubscriberStatusCallback changed = [on_change](const auto&) { on_change(); };
  const image_transport::SubscriberStatusCallback image_changed = [on_change](const auto&) {
    on_change();
  };
  image_transport::ImageTransport images(nh);
  disparity_ = nh.advertise<stereo_msgs::DisparityImage>("disparity", 1, changed, changed);
  cloud_ = nh.advertise<sensor_msgs::PointCloud2>("points2", 1, changed, changed);
  priors_ = nh.advertise<stereo_sgmp::Priors>("priors", 1, changed, changed);
  statistics_ = nh.advertise<stereo_sgmp::Statistics>("statistics", 1, changed, changed);
  confidence_ = images.advertise("confidence", 1, image_changed, image_changed);
  disparity_color_ = images.advertise("disparity_color", 1, image_changed, image_changed);
  priors_color_ = images.advertise("priors_color", 1, image_changed, image_changed);
}

void Outputs::Shutdown() {
  for (ros::Publisher* publisher : {&disparity_, &cloud_, &priors_, &statistics_}) {
    publisher->shutdown();
  }
  for (image_transport::Publisher* publisher : {&confidence_, &disparity_color_, &priors_color_}) {
    publisher->shutdown();
  }
}

bool Outputs::AnyWanted() const {
  return disparity_.getNumSubscribers() > 0 || cloud_.getNumSubscribers() > 0 ||
         priors_.getNumSubscribers() > 0 || statistics_.getNumSubscribers() > 0 ||
         confidence_.getNumSubscribers() > 0 || disparity_color_.getNumSubscribers() > 0 ||
         priors_color_.getNumSubscribers() > 0;
}

void Outputs::PublishMaps(const MatchedFrame& frame) {
  const MatchResult& result = frame.result;
  if (disparity_.getNumSubscribers() > 0) {
    disparity_.publish(ToDisparityImage(result, frame.options, frame.camera, frame.header));
  }
  if (confidence_.getNumSubscribers() > 0) {
    confidence_.publish(ToImageMessage(result.confidence, enc::TYPE_32FC1, frame.header));
  }
  if (priors_.getNumSubscribers() > 0) {
    priors_.publish(ToPriors(result.priors, frame.camera, frame.header));
  }
  if (disparity_color_.getNumSubscribers() > 0) {
    const cv::Mat picture = DisparityPicture(result, frame.options);
    disparity_color_.publish(ToImageMessage(picture, enc::BGR8, frame.header));
  }
  if (priors_color_.getNumSubscribers() > 0) {
    const cv::Mat picture = PriorPicture(result.priors, result.dense.size());
    priors_color_.publish(ToImageMessage(picture, enc::BGR8, frame.header));
  }
}

void Outputs::PublishCloud(const MatchedFrame& frame, const cv::Mat& image) {
  ComputePointCloud(frame.result, frame.camera, image, CloudOptions(), &points_);
  cloud_.publish(ToPointCloud2(points_, frame.header));
}

void Outputs::PublishStatistics(const MatchedFrame& frame, double latency_ms,
                                const FrameCounts& counts) {
  if (statistics_.getNumSubscribers() == 0) return;
  const stereo_sgmp::StatisticsPtr message = ToStatistics(frame.result, frame.header);
  message->latency_ms = latency_ms;
  message->frames = counts.matched;
  message->dropped = counts.dropped;
  message->rejected = counts.rejected;
  statistics_.publish(message);
}

}  // namespace stereo_sgmp
