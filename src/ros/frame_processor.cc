#include "ros/frame_processor.h"

#include <chrono>
#include <exception>
#include <stdexcept>
#include <utility>

#include "ros/camera_model.h"
#include "ros/conversions.h"

namespace stereo_sgmp {
namespace {

// For the colour of a cloud, while the next frame is matched.
constexpr std::chrono::milliseconds kColorPatience(20);

double MillisecondsSince(const ros::WallTime& start) {
  return (ros::WallTime::now() - start).toSec() * 1e3;
}

}  // namespace

FrameProcessor::FrameProcessor(const NodeletOptions& options, Outputs* outputs,
                               const ColorImages* colors, Diagnostics* diagnostics, Tell tell)
    : outputs_(outputs),
      colors_(colors),
      diagnostics_(diagnostics),
      tell_(std::move(tell)),
      matcher_(options) {}

void FrameProcessor::SetOptions(const NodeletOptions& options) {
  std::lock_guard<std::mutex> lock(options_mutex_);
  new_options_ = options;
}

void FrameProcessor::TakeNewOptions() {
  std::lock_guard<std::mutex> lock(options_mutex_);
  if (new_options_) matcher_.SetOptions(*std::exchange(new_options_, std::nullopt));
}

void FrameProcessor::Process(const StereoFrame& frame, std::uint64_t dropped) {
  if (!outputs_->AnyWanted()) return;  // the last listener has just gone
  const ros::WallTime start = ros::WallTime::now();
  RejectErrors([&] {
    MatchAndPublish(frame, dropped);
    matcher_.NoteFrameTime((ros::WallTime::now() - start).toSec());
  });
}

void FrameProcessor::RejectErrors(const std::function<void()>& work) {
  try {
    work();
  } catch (const std::exception& error) {
    Reject(error.what(), error.what());
  } catch (...) {
    Reject("unknown", "a frame failed for an unknown reason; it is skipped");
  }
}

void FrameProcessor::Reject(const std::string& kind, const std::string& problem) {
  ++rejected_;
  diagnostics_->NoteRejection(problem);
  tell_(Severity::kError, kind, problem);
}

void FrameProcessor::MatchAndPublish(const StereoFrame& frame, std::uint64_t dropped) {
  const InputPair images = ToInputPair(frame.left, frame.right);
  const StereoCamera camera =
      CameraFromInfo(*frame.left_info, *frame.right_info, images.left->image.size());

  // The colour image may come after the gray ones, or be gone when matching took long.
  sensor_msgs::ImageConstPtr color;
  if (outputs_->CloudWanted()) color = colors_->Find(frame.left->header.stamp);
  TakeNewOptions();
  matcher_.Match(images.left->image, images.right->image, camera);
  const MatchedFrame matched{matcher_.result(), matcher_.match_options(), camera,
                             matcher_.level().scale, frame.left->header};
  outputs_->PublishMaps(matched);
  ++matched_;
  const stereo_sgmp::StatisticsPtr statistics = MakeStatistics(matched, frame.arrival, dropped);
  matcher_.KeepResult();
  const CloudStreamOptions& cloud = matcher_.options().stream.cloud;
  follow_up_.Start([=, left = images.left, arrival = frame.arrival] {
    FollowUp(matched, cloud, color, left, arrival, statistics);
  });
  PublishBaseline(matched, images);
  CheckRig(frame, images, camera);
}

// While the next frame is matched.
void FrameProcessor::FollowUp(const MatchedFrame& matched, const CloudStreamOptions& cloud,
                              sensor_msgs::ImageConstPtr color,
                              const cv_bridge::CvImageConstPtr& left, const ros::WallTime& arrival,
                              const stereo_sgmp::StatisticsPtr& statistics) {
  RejectErrors([&] {
    if (outputs_->CloudWanted()) {
      if (!color) color = colors_->WaitFor(matched.header.stamp, kColorPatience);
      outputs_->PublishCloud(matched, CloudColor(color, left)->image, cloud);
      statistics->cloud_latency_ms = MillisecondsSince(arrival);
    }
    outputs_->PublishStatistics(statistics);
    diagnostics_->NoteFrame(statistics);
  });
}

void FrameProcessor::CheckRig(const StereoFrame& frame, const InputPair& images,
                              const StereoCamera& camera) {
  const std::string frame_problem = FrameIdProblem(*frame.left_info, *frame.right_info);
  if (!frame_problem.empty()) tell_(Severity::kWarning, "frame_id", frame_problem);
  const std::string& range_problem = matcher_.range_problem();
  if (!range_problem.empty()) tell_(Severity::kWarning, "range", range_problem);
  const std::string& note = matcher_.result().priors.note;
  if (!note.empty()) tell_(Severity::kWarning, note, note);
  const Options& options = matcher_.match_options();
  const std::string report = calibration_log_.Update(camera, images.left->image.size(), options);
  if (!report.empty()) tell_(Severity::kInfo, report, report);
  for (const RigProblem& problem : rig_watch_.Check(images.left->image, images.right->image,
                                                    options, matcher_.result().statistics)) {
    tell_(Severity::kWarning, problem.kind, problem.text);
  }
}

// The colour image of the same exposure if it has come and is usable, else the left one.
cv_bridge::CvImageConstPtr FrameProcessor::CloudColor(
    const sensor_msgs::ImageConstPtr& color, const cv_bridge::CvImageConstPtr& left) const {
  if (!color) return left;
  try {
    cv_bridge::CvImageConstPtr image = ToImage(color, "left/image_rect_color");
    if (image->image.size() == left->image.size()) return image;
    tell_(Severity::kWarning, "color size",
          "left/image_rect_color is of " + std::to_string(color->width) + " x " +
              std::to_string(color->height) + " pixels, left/image_rect of " +
              std::to_string(left->image.cols) + " x " + std::to_string(left->image.rows) +
              "; expected one size; the cloud stays gray");
  } catch (const std::invalid_argument& error) {
    tell_(Severity::kWarning, error.what(), std::string(error.what()) + "; the cloud stays gray");
  }
  return left;
}

void FrameProcessor::PublishBaseline(const MatchedFrame& matched, const InputPair& images) {
  if (!outputs_->BaselineWanted()) return matcher_.ReleaseBaseline();
  matcher_.MatchBaseline(images.left->image, images.right->image);
  outputs_->PublishBaseline({matcher_.baseline_result(), matcher_.baseline_options(),
                             matched.camera, matched.scale, matched.header});
}

stereo_sgmp::StatisticsPtr FrameProcessor::MakeStatistics(const MatchedFrame& matched,
                                                          const ros::WallTime& arrival,
                                                          std::uint64_t dropped) const {
  stereo_sgmp::StatisticsPtr message = ToStatistics(matched.result, matched.header);
  message->latency_ms = MillisecondsSince(arrival);
  // As numbers: a ros::Duration does not hold every difference of two stamps.
  message->age_ms = (ros::Time::now().toSec() - matched.header.stamp.toSec()) * 1e3;
  message->frames = matched_;
  message->dropped = dropped;
  message->rejected = rejected_;
  message->load_level = static_cast<std::uint8_t>(matcher_.level_index());
  message->load = matcher_.level().name;
  return message;
}

}  // namespace stereo_sgmp
