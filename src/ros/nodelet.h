#ifndef STEREO_SGMP_ROS_NODELET_H_
#define STEREO_SGMP_ROS_NODELET_H_

#include <cstddef>
#include <cstdint>
#include <memory>
#include <mutex>
#include <string>

#include <cv_bridge/cv_bridge.h>
#include <dynamic_reconfigure/server.h>
#include <image_transport/image_transport.h>
#include <nodelet/nodelet.h>
#include <ros/subscriber.h>
#include <stereo_sgmp/StereoSgmpConfig.h>
#include <boost/thread/recursive_mutex.hpp>

#include "ros/color_images.h"
#include "ros/outputs.h"
#include "ros/problem_log.h"
#include "ros/stereo_frame.h"
#include "ros/synchronizer.h"
#include "ros/worker.h"
#include "stereo_sgmp/match_result.h"
#include "stereo_sgmp/matcher.h"
#include "stereo_sgmp/options.h"

namespace stereo_sgmp {

// Rectified stereo images in; disparity, cloud, confidence, priors and statistics out.
//
// Threads: all callbacks come from the nodelet's single-threaded queue, and only hand messages
// on. A thread of its own matches the newest frame and publishes. What both sides touch has a
// lock of its own: ColorImages, ProblemLog, NewestItemWorker, and the options in here.
class StereoSgmpNodelet : public nodelet::Nodelet {
 public:
  ~StereoSgmpNodelet() override;

 private:
  // Set-up.
  void onInit() override;

  // Subscribes while somebody listens to an output, and only then.
  void Connect();
  void Subscribe();
  void Unsubscribe();
  void ConnectColor();

  void Reconfigure(StereoSgmpConfig& config);

  // The worker's side. Process does not throw.
  void Process(const StereoFrame& frame);
  void MatchAndPublish(const StereoFrame& frame);
  cv_bridge::CvImageConstPtr CloudColor(const sensor_msgs::ImageConstPtr& color,
                                        const cv_bridge::CvImageConstPtr& left);
  void ApplyOptions();

  // At most once in a while for each kind: of what still gives a result, and of what does not.
  void Warn(const std::string& kind, const std::string& problem);
  void Report(const std::string& kind, const std::string& problem);

  static constexpr std::size_t kColorImages = 10;

  ProblemLog problems_{ros::WallDuration(5.0)};
  ColorImages colors_{kColorImages};
  Outputs outputs_;

  std::mutex options_mutex_;  // guards the two below
  Options options_;
  bool options_changed_ = false;

  // Of the worker's thread alone.
  std::unique_ptr<Matcher> matcher_;
  MatchResult result_;
  FrameCounts counts_;

  std::unique_ptr<NewestItemWorker<StereoFrame>> worker_;
  std::unique_ptr<StereoSynchronizer> synchronizer_;

  std::mutex connect_mutex_;  // guards the below, but for the reconfigure server
  bool closing_ = false;
  std::unique_ptr<image_transport::ImageTransport> images_;
  image_transport::Subscriber left_image_;
  image_transport::Subscriber right_image_;
  image_transport::Subscriber left_color_;
  ros::Subscriber left_info_;
  ros::Subscriber right_info_;

  boost::recursive_mutex reconfigure_mutex_;
  std::unique_ptr<dynamic_reconfigure::Server<StereoSgmpConfig>> reconfigure_server_;
};

}  // namespace stereo_sgmp

#endif  // STEREO_SGMP_ROS_NODELET_H_
