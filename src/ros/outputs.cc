#include "ros/outputs.h"

#include <algorithm>
#include <cstddef>

#include <sensor_msgs/image_encodings.h>

#include "ros/conversions.h"
#include "ros/prior_markers.h"

namespace stereo_sgmp {
namespace {

namespace enc = sensor_msgs::image_encodings;

// How far the drawn planes reach: a little beyond the farthest point that is seen.
double MarkerDepth(const MatchedFrame& frame) {
  constexpr double kBeyond = 1.2;
  constexpr double kLeastDisparity = 0.5;  // px
  double least = 0.0;
  const cv::Mat valid = frame.result.reason == 0;
  if (cv::countNonZero(valid) > 0) {
    cv::minMaxLoc(frame.result.dense, &least, nullptr, nullptr, nullptr, valid);
  }
  const double doffs = frame.camera.doffs;
  return kBeyond * frame.camera.DepthOf(std::max(least, kLeastDisparity - doffs));
}

template <class Publisher>
bool IsWanted(const Publisher& publisher) {
  return publisher.getNumSubscribers() > 0;
}

}  // namespace

void Outputs::Advertise(ros::NodeHandle& nh, const std::function<void()>& on_change) {
  const ros::SubscriberStatusCallback changed = [on_change](const auto&) { on_change(); };
  const image_transport::SubscriberStatusCallback image_changed = [on_change](const auto&) {
    on_change();
  };
  disparity_ = nh.advertise<stereo_msgs::DisparityImage>("disparity", 1, changed, changed);
  cloud_ = nh.advertise<sensor_msgs::PointCloud2>("points2", 1, changed, changed);
  priors_ = nh.advertise<stereo_sgmp::Priors>("priors", 1, changed, changed);
  markers_ = nh.advertise<visualization_msgs::MarkerArray>("priors_markers", 1, changed, changed);
  baseline_ = nh.advertise<stereo_msgs::DisparityImage>("disparity_baseline", 1, changed, changed);
  statistics_ = nh.advertise<stereo_sgmp::Statistics>("statistics", 1, changed, changed);
  image_transport::ImageTransport images(nh);
  baseline_color_ = images.advertise("disparity_baseline_color", 1, image_changed, image_changed);
  for (std::size_t i = 0; i < images_.size(); ++i) {
    images_[i] = images.advertise(MapImages()[i].topic, 1, image_changed, image_changed);
  }
}

void Outputs::Shutdown() {
  for (ros::Publisher* publisher :
       {&disparity_, &cloud_, &priors_, &markers_, &baseline_, &statistics_}) {
    publisher->shutdown();
  }
  baseline_color_.shutdown();
  for (image_transport::Publisher& publisher : images_) publisher.shutdown();
}

bool Outputs::AnyWanted() const {
  return IsWanted(disparity_) || IsWanted(cloud_) || IsWanted(priors_) || IsWanted(markers_) ||
         BaselineWanted() || IsWanted(statistics_) ||
         std::any_of(images_.begin(), images_.end(), IsWanted<image_transport::Publisher>);
}

void Outputs::PublishMaps(const MatchedFrame& frame) {
  const MatchResult& result = frame.result;
  if (IsWanted(disparity_)) {
    const stereo_msgs::DisparityImagePtr message = disparities_.Get();
    FillDisparityImage(result, frame.options, frame.camera, frame.header, message.get());
    disparity_.publish(message);
  }
  for (std::size_t i = 0; i < images_.size(); ++i) {
    if (!IsWanted(images_[i])) continue;
    const MapImage& map = MapImages()[i];
    images_[i].publish(ToImageMessage(map.make(frame), map.encoding, frame.header));
  }
  if (IsWanted(priors_)) priors_.publish(ToPriors(result.priors, frame.camera, frame.header));
  if (IsWanted(markers_)) {
    markers_.publish(ToPriorMarkers(result.priors, result.dense.size(), frame.camera,
                                    MarkerDepth(frame), frame.header));
  }
}

void Outputs::PublishCloud(const MatchedFrame& frame, const cv::Mat& image,
                           const CloudStreamOptions& options) {
  if (options.Organised()) {
    const sensor_msgs::PointCloud2Ptr message = clouds_.Get();
    FillPointCloud2(CloudRows(frame.result, frame.camera, image, CloudOptions()), options.compact,
                    frame.header, message.get());
    cloud_.publish(message);
  } else {
    ComputePointCloud(frame.result, frame.camera, image, CloudOptions(), &points_);
    const PointCloud filtered = FilterCloud(points_, options.filter);
    cloud_.publish(ToPointCloud2(filtered, {options.compact, true}, frame.header));
  }
}

void Outputs::PublishBaseline(const MatchedFrame& frame) const {
  if (IsWanted(baseline_)) {
    baseline_.publish(ToDisparityImage(frame.result, frame.options, frame.camera, frame.header));
  }
  if (IsWanted(baseline_color_)) {
    baseline_color_.publish(ToImageMessage(DisparityPicture(frame), enc::BGR8, frame.header));
  }
}

void Outputs::PublishStatistics(const stereo_sgmp::StatisticsConstPtr& message) const {
  if (IsWanted(statistics_)) statistics_.publish(message);
}

}  // namespace stereo_sgmp
