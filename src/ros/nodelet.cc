#include "ros/nodelet.h"

#include <cstdint>
#include <stdexcept>
#include <string>

#include <XmlRpcValue.h>
#include <ros/master.h>
#include <ros/this_node.h>
#include <pluginlib/class_list_macros.hpp>

#include "ros/parameters.h"

namespace stereo_sgmp {
namespace {

// What the master knows; nothing where it does not answer at once.
std::vector<PublishedTopic> PublishedTopics() {
  XmlRpc::XmlRpcValue request;
  XmlRpc::XmlRpcValue response;
  XmlRpc::XmlRpcValue topics;
  request[0] = ros::this_node::getName();
  request[1] = "";
  constexpr bool kWait = false;
  std::vector<PublishedTopic> published;
  if (!ros::master::execute("getPublishedTopics", request, response, topics, kWait)) {
    return published;
  }
  const int count = topics.size();
  for (int i = 0; i < count; ++i) {
    published.push_back({topics[i][0], topics[i][1]});
  }
  return published;
}

}  // namespace

void StereoSgmpNodelet::onInit() {
  ros::NodeHandle& nh = getNodeHandle();
  ros::NodeHandle& private_nh = getPrivateNodeHandle();
  const auto report = [this](const std::string& problem) { NODELET_WARN_STREAM(problem); };

  // dynamic_reconfigure calls back as soon as it has a callback: the options come first.
  options_ = ReadOptions(private_nh, report);
  diagnostics_ = std::make_unique<Diagnostics>(nh, private_nh, getName());
  MakeWorker(options_);
  synchronizer_ = std::make_unique<StereoSynchronizer>(
      ReadSynchronizerSettings(private_nh, report),
      [this](const StereoFrame& frame) { worker_->Offer(frame); },
      [this](const std::string& kind, const std::string& problem) {
        Tell(Severity::kWarning, kind, problem);
      });

  reconfigure_server_ = std::make_unique<dynamic_reconfigure::Server<StereoSgmpConfig>>(
      reconfigure_mutex_, private_nh);
  reconfigure_server_->updateConfig(ToConfig(options_));
  reconfigure_server_->setCallback(
      [this](StereoSgmpConfig& config, std::uint32_t) { Reconfigure(config); });

  // Listeners may come before all topics are advertised: Connect waits for the lock.
  std::lock_guard<std::mutex> lock(connect_mutex_);
  images_ = std::make_unique<image_transport::ImageTransport>(nh);
  outputs_.Advertise(nh, [this] { Connect(); });
  watch_timer_ = nh.createWallTimer(ros::WallDuration(1.0), [this](const auto&) { Watch(); });
  leave_timer_ =
      nh.createWallTimer(ros::WallDuration(0.25), [this](const auto&) { LeaveUnwanted(); });
}

void StereoSgmpNodelet::MakeWorker(const NodeletOptions& options) {
  processor_ = std::make_unique<FrameProcessor>(
      options, &outputs_, &colors_, diagnostics_.get(),
      [this](Severity severity, const std::string& kind, const std::string& text) {
        Tell(severity, kind, text);
      });
  worker_ = std::make_unique<NewestItemWorker<StereoFrame>>(
      [this](const StereoFrame& frame) { processor_->Process(frame, worker_->dropped()); });
}

StereoSgmpNodelet::~StereoSgmpNodelet() {
  watch_timer_.stop();
  leave_timer_.stop();
  reconfigure_server_.reset();
  {
    std::lock_guard<std::mutex> lock(connect_mutex_);
    closing_ = true;  // listeners that come or go from now on change nothing
    Unsubscribe();
  }
  // What publishes ends before the publishers, and these, whose callbacks come to Connect, before
  // the rest.
  if (worker_) worker_->Stop();
  processor_.reset();
  outputs_.Shutdown();
}

void StereoSgmpNodelet::Connect() {
  std::lock_guard<std::mutex> lock(connect_mutex_);
  if (closing_) return;
  if (outputs_.AnyWanted() && !left_info_) Subscribe();
  if (outputs_.CloudWanted() && !left_color_) SubscribeColor();
}

void StereoSgmpNodelet::LeaveUnwanted() {
  constexpr int kPatience = 2;  // checks in a row that find nobody
  std::lock_guard<std::mutex> lock(connect_mutex_);
  if (closing_) return;
  unwanted_checks_ = outputs_.AnyWanted() ? 0 : unwanted_checks_ + 1;
  if (left_info_ && unwanted_checks_ >= kPatience) Unsubscribe();
  unwanted_cloud_checks_ = outputs_.CloudWanted() ? 0 : unwanted_cloud_checks_ + 1;
  if (left_color_ && unwanted_cloud_checks_ >= kPatience) UnsubscribeColor();
}

void StereoSgmpNodelet::Subscribe() {
  ros::NodeHandle& nh = getNodeHandle();
  const image_transport::TransportHints hints("raw", ros::TransportHints(), getPrivateNodeHandle());
  // A queue of one each would lose partners of messages that arrive in bursts.
  constexpr std::uint32_t kQueue = 5;
  StereoSynchronizer* synchronizer = synchronizer_.get();
  synchronizer->Reset();
  input_watch_.Reset();
  left_image_ = images_->subscribe("left/image_rect", kQueue, &StereoSynchronizer::AddLeftImage,
                                   synchronizer, hints);
  right_image_ = images_->subscribe("right/image_rect", kQueue, &StereoSynchronizer::AddRightImage,
                                    synchronizer, hints);
  left_info_ =
      nh.subscribe("left/camera_info", kQueue, &StereoSynchronizer::AddLeftInfo, synchronizer);
  right_info_ =
      nh.subscribe("right/camera_info", kQueue, &StereoSynchronizer::AddRightInfo, synchronizer);
}

void StereoSgmpNodelet::Unsubscribe() {
  left_image_.shutdown();
  right_image_.shutdown();
  left_info_.shutdown();
  right_info_.shutdown();
  UnsubscribeColor();
  if (worker_) worker_->Clear();
}

// Colour serves the cloud alone. The subscription does not need a publisher: without colour
// images the cloud is gray.
void StereoSgmpNodelet::SubscribeColor() {
  const image_transport::TransportHints hints("raw", ros::TransportHints(), getPrivateNodeHandle());
  left_color_ = images_->subscribe("left/image_rect_color", 5, &ColorImages::Add, &colors_, hints);
}

void StereoSgmpNodelet::UnsubscribeColor() {
  left_color_.shutdown();
  colors_.Clear();
}

void StereoSgmpNodelet::Reconfigure(StereoSgmpConfig& config) {
  try {
    options_ = FromConfig(config);
    processor_->SetOptions(options_);
  } catch (const std::invalid_argument& error) {
    config = ToConfig(options_);
    NODELET_ERROR_STREAM(error.what() << "; the options stay as they were");
  }
}

void StereoSgmpNodelet::Watch() {
  std::vector<InputTopic> inputs;
  bool listening = false;
  {
    std::lock_guard<std::mutex> lock(connect_mutex_);
    inputs = Inputs();
    listening = static_cast<bool>(left_info_);
  }
  diagnostics_->Update(inputs, listening);
  if (listening && input_watch_.IsSilent(inputs, ros::WallTime::now())) {
    Tell(Severity::kWarning, "silence", SilenceAdvice(inputs, PublishedTopics()));
  }
}

std::vector<InputTopic> StereoSgmpNodelet::Inputs() const {
  const StereoSynchronizer::Counts& received = synchronizer_->received();
  const std::string image = "sensor_msgs/Image";
  const std::string info = "sensor_msgs/CameraInfo";
  const ros::NodeHandle& nh = getNodeHandle();
  return {{nh.resolveName("left/image_rect"), image, received[0], left_image_.getNumPublishers()},
          {nh.resolveName("left/camera_info"), info, received[1], left_info_.getNumPublishers()},
          {nh.resolveName("right/image_rect"), image, received[2], right_image_.getNumPublishers()},
          {nh.resolveName("right/camera_info"), info, received[3], right_info_.getNumPublishers()}};
}

void StereoSgmpNodelet::Tell(Severity severity, const std::string& kind, const std::string& text) {
  if (severity == Severity::kInfo) {
    NODELET_INFO_STREAM(text);
  } else if (!problems_.ShouldTell(kind)) {
    return;
  } else if (severity == Severity::kWarning) {
    NODELET_WARN_STREAM(text);
  } else {
    NODELET_ERROR_STREAM(text);
  }
}

}  // namespace stereo_sgmp

PLUGINLIB_EXPORT_CLASS(stereo_sgmp::StereoSgmpNodelet, nodelet::Nodelet)
