#include "ros/nodelet.h"

#include <exception>
#include <stdexcept>
#include <string>
#include <utility>

#include <pluginlib/class_list_macros.hpp>

#include "ros/camera_model.h"
#include "ros/input_images.h"
#include "ros/parameters.h"

namespace stereo_sgmp {

void StereoSgmpNodelet::onInit() {
  ros::NodeHandle& nh = getNodeHandle();
  ros::NodeHandle& private_nh = getPrivateNodeHandle();
  const auto report = [this](const std::string& problem) { NODELET_WARN_STREAM(problem); };

  // dynamic_reconfigure calls back as soon as it has a callback: the options come first.
  options_ = ReadOptions(private_nh, report);
  matcher_ = std::make_unique<Matcher>(options_);
  worker_ = std::make_unique<NewestItemWorker<StereoFrame>>(
      [this](const StereoFrame& frame) { Process(frame); });
  synchronizer_ = std::make_unique<StereoSynchronizer>(
      ReadSynchronizerSettings(private_nh, report),
      [this](const StereoFrame& frame) { worker_->Offer(frame); },
      [this](const std::string& kind, const std::string& problem) { Warn(kind, problem); });

  reconfigure_server_ = std::make_unique<dynamic_reconfigure::Server<StereoSgmpConfig>>(
      reconfigure_mutex_, private_nh);
  reconfigure_server_->updateConfig(ToConfig(options_));
  reconfigure_server_->setCallback(
      [this](StereoSgmpConfig& config, std::uint32_t) { Reconfigure(config); });

  // Listeners may come before all topics are advertised: Connect waits for the lock.
  std::lock_guard<std::mutex> lock(connect_mutex_);
  images_ = std::make_unique<image_transport::ImageTransport>(nh);
  outputs_.Advertise(nh, [this] { Connect(); });
}

StereoSgmpNodelet::~StereoSgmpNodelet() {
  reconfigure_server_.reset();
  {
    std::lock_guard<std::mutex> lock(connect_mutex_);
    closing_ = true;  // listeners that come or go from now on change nothing
    Unsubscribe();
  }
  // What publishes ends before the publishers, and these, whose callbacks come to Connect, before
  // the rest.
  if (worker_) worker_->Stop();
  outputs_.Shutdown();
}

void StereoSgmpNodelet::Connect() {
  std::lock_guard<std::mutex> lock(connect_mutex_);
  if (closing_) return;
  if (!outputs_.AnyWanted()) {
    Unsubscribe();
  } else {
    if (!left_info_) Subscribe();
    ConnectColor();
  }
}

void StereoSgmpNodelet::Subscribe() {
  ros::NodeHandle& nh = getNodeHandle();
  const image_transport::TransportHints hints("raw", ros::TransportHints(), getPrivateNodeHandle());
  // A queue of one each would lose partners of messages that arrive in bursts.
  constexpr std::uint32_t kQueue = 5;
  StereoSynchronizer* synchronizer = synchronizer_.get();
  synchronizer->Reset();
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
  left_color_.shutdown();
  left_info_.shutdown();
  right_info_.shutdown();
  colors_.Clear();
  if (worker_) worker_->Clear();
}

// Colour serves the cloud alone. The subscription does not need a publisher: without colour
// images the cloud is gray.
void StereoSgmpNodelet::ConnectColor() {
  if (!outputs_.CloudWanted()) {
    left_color_.shutdown();
    colors_.Clear();
  } else if (!left_color_) {
    const image_transport::TransportHints hints("raw", ros::TransportHints(),
                                                getPrivateNodeHandle());
    left_color_ =
        images_->subscribe("left/image_rect_color", 5, &ColorImages::Add, &colors_, hints);
  }
}

void StereoSgmpNodelet::Reconfigure(StereoSgmpConfig& config) {
  std::lock_guard<std::mutex> lock(options_mutex_);
  try {
    options_ = FromConfig(config);
    options_changed_ = true;
  } catch (const std::invalid_argument& error) {
    config = ToConfig(options_);
    NODELET_ERROR_STREAM(error.what() << "; the options stay as they were");
  }
}

void StereoSgmpNodelet::Process(const StereoFrame& frame) {
  try {
    MatchAndPublish(frame);
    ++counts_.matched;
  } catch (const std::exception& error) {
    ++counts_.rejected;
    Report(error.what(), error.what());
  } catch (...) {
    ++counts_.rejected;
    Report("unknown", "a frame failed for an unknown reason; it is skipped");
  }
}

void StereoSgmpNodelet::MatchAndPublish(const StereoFrame& frame) {
  const InputPair images = ToInputPair(frame.left, frame.right);
  const StereoCamera camera =
      CameraFromInfo(*frame.left_info, *frame.right_info, images.left->image.size());
  const std::string frame_problem = FrameIdProblem(*frame.left_info, *frame.right_info);
  if (!frame_problem.empty()) Warn("frame_id", frame_problem);

  // The colour image may come after the gray ones, or be gone when matching took long.
  sensor_msgs::ImageConstPtr color;
  if (outputs_.CloudWanted()) color = colors_.Find(frame.left->header.stamp);
  ApplyOptions();
  MatchInputs inputs;
  inputs.camera = camera;
  matcher_->Match(images.left->image, images.right->image, inputs, &result_);
  const std::string& note = result_.priors.note;
  if (!note.empty()) Warn(note, note);
  const MatchedFrame matched{result_, matcher_->options(), camera, frame.left->header};
  outputs_.PublishMaps(matched);
  const double latency_ms = (ros::WallTime::now() - frame.arrival).toSec() * 1e3;
  if (outputs_.CloudWanted()) {
    if (!color) color = colors_.Find(frame.left->header.stamp);
    outputs_.PublishCloud(matched, CloudColor(color, images.left)->image);
  }
  FrameCounts counts = counts_;
  ++counts.matched;
  counts.dropped = worker_->dropped();
  outputs_.PublishStatistics(matched, latency_ms, counts);
}

// The colour image of the same exposure if it has come and is usable, else the left one.
cv_bridge::CvImageConstPtr StereoSgmpNodelet::CloudColor(const sensor_msgs::ImageConstPtr& color,
                                                         const cv_bridge::CvImageConstPtr& left) {
  if (!color) return left;
  try {
    const cv_bridge::CvImageConstPtr image = ToImage(color, "left/image_rect_color");
    if (image->image.size() == left->image.size()) return image;
    Warn("color size", "left/image_rect_color is of " + std::to_string(color->width) + " x " +
                           std::to_string(color->height) + " pixels, left/image_rect of " +
                           std::to_string(left->image.cols) + " x " +
                           std::to_string(left->image.rows) +
                           "; expected one size; the cloud stays gray");
  } catch (const std::invalid_argument& error) {
    Warn(error.what(), std::string(error.what()) + "; the cloud stays gray");
  }
  return left;
}

void StereoSgmpNodelet::ApplyOptions() {
  std::lock_guard<std::mutex> lock(options_mutex_);
  if (!std::exchange(options_changed_, false)) return;
  matcher_->SetOptions(options_);
}

void StereoSgmpNodelet::Warn(const std::string& kind, const std::string& problem) {
  if (problems_.ShouldTell(kind)) NODELET_WARN_STREAM(problem);
}

void StereoSgmpNodelet::Report(const std::string& kind, const std::string& problem) {
  if (problems_.ShouldTell(kind)) NODELET_ERROR_STREAM(problem);
}

}  // namespace stereo_sgmp

PLUGINLIB_EXPORT_CLASS(stereo_sgmp::StereoSgmpNodelet, nodelet::Nodelet)
