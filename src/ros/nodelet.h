#ifndef STEREO_SGMP_ROS_NODELET_H_
#define STEREO_SGMP_ROS_NODELET_H_

#include <cstddef>
#include <memory>
#include <mutex>
#include <string>
#include <vector>

#include <dynamic_reconfigure/server.h>
#include <image_transport/image_transport.h>
#include <nodelet/nodelet.h>
#include <ros/subscriber.h>
#include <ros/wall_timer.h>
#include <stereo_sgmp/StereoSgmpConfig.h>
#include <boost/thread/recursive_mutex.hpp>

#include "ros/color_images.h"
#include "ros/diagnostics.h"
#include "ros/frame_processor.h"
#include "ros/input_watch.h"
#include "ros/outputs.h"
#include "ros/problem_log.h"
#include "ros/stereo_frame.h"
#include "ros/stream_options.h"
#include "ros/synchronizer.h"
#include "ros/worker.h"

namespace stereo_sgmp {

// Rectified stereo images in; disparity, cloud, depth, confidence, priors and statistics out.
//
// Threads: all callbacks come from the nodelet's single-threaded queue, and only hand messages
// on. A thread of its own matches the newest frame and publishes. What both sides touch has a
// lock of its own: ColorImages, ProblemLog, Diagnostics, NewestItemWorker, FrameProcessor's
// options.
class StereoSgmpNodelet : public nodelet::Nodelet {
 public:
  ~StereoSgmpNodelet() override;

 private:
  // Set-up.
  void onInit() override;
  void MakeWorker(const NodeletOptions& options);

  // Subscribes while somebody listens to an output. Leaves the inputs some time after the last
  // listener has gone: each subscription takes several exchanges with the master and the cameras,
  // which would pile up where listeners come and go.
  void Connect();
  void LeaveUnwanted();
  void Subscribe();
  void Unsubscribe();
  void SubscribeColor();
  void UnsubscribeColor();

  void Reconfigure(StereoSgmpConfig& config);

  // Once a second: diagnostics, and a warning when nothing arrives.
  void Watch();
  std::vector<InputTopic> Inputs() const;

  // At most once in a while for each kind, but for what only informs.
  void Tell(Severity severity, const std::string& kind, const std::string& text);

  static constexpr std::size_t kColorImages = 10;

  ProblemLog problems_{ros::WallDuration(5.0)};
  ColorImages colors_{kColorImages};
  Outputs outputs_;
  NodeletOptions options_;  // of the callbacks alone
  std::unique_ptr<Diagnostics> diagnostics_;
  std::unique_ptr<FrameProcessor> processor_;
  std::unique_ptr<NewestItemWorker<StereoFrame>> worker_;
  std::unique_ptr<StereoSynchronizer> synchronizer_;
  InputWatch input_watch_;
  ros::WallTimer watch_timer_;
  ros::WallTimer leave_timer_;

  std::mutex connect_mutex_;  // guards the below, but for the reconfigure server
  bool closing_ = false;
  int unwanted_checks_ = 0;  // in a row
  int unwanted_cloud_checks_ = 0;
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
