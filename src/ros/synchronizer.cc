#include "ros/synchronizer.h"

#include <algorithm>
#include <exception>
#include <sstream>
#include <utility>

#include <message_filters/sync_policies/approximate_time.h>
#include <message_filters/sync_policies/exact_time.h>
#include <message_filters/synchronizer.h>

namespace stereo_sgmp {
namespace {

using sensor_msgs::CameraInfo;
using sensor_msgs::CameraInfoConstPtr;
using sensor_msgs::Image;
using sensor_msgs::ImageConstPtr;

enum : std::size_t { kLeftImage, kLeftInfo, kRightImage, kRightInfo };
constexpr const char* kNames[] = {"left/image_rect", "left/camera_info", "right/image_rect",
                                  "right/camera_info"};

}  // namespace

class StereoSynchronizer::Policy {
 public:
  virtual ~Policy() = default;
  virtual void AddLeftImage(const ImageConstPtr& message) = 0;
  virtual void AddLeftInfo(const CameraInfoConstPtr& message) = 0;
  virtual void AddRightImage(const ImageConstPtr& message) = 0;
  virtual void AddRightInfo(const CameraInfoConstPtr& message) = 0;
};

namespace {

// The same four calls for either of the policies of message_filters.
template <class Base, class FilterPolicy>
class PolicyOver : public Base {
 public:
  template <class Owner, class Handler>
  PolicyOver(const FilterPolicy& policy, Owner* owner, Handler handler) : synchronizer_(policy) {
    synchronizer_.registerCallback(handler, owner);
  }

  void AddLeftImage(const ImageConstPtr& message) override {
    synchronizer_.template add<kLeftImage>(message);
  }
  void AddLeftInfo(const CameraInfoConstPtr& message) override {
    synchronizer_.template add<kLeftInfo>(message);
  }
  void AddRightImage(const ImageConstPtr& message) override {
    synchronizer_.template add<kRightImage>(message);
  }
  void AddRightInfo(const CameraInfoConstPtr& message) override {
    synchronizer_.template add<kRightInfo>(message);
  }

 private:
  message_filters::Synchronizer<FilterPolicy> synchronizer_;
};

using ExactTime = message_filters::sync_policies::ExactTime<Image, CameraInfo, Image, CameraInfo>;
using ApproximateTime =
    message_filters::sync_policies::ApproximateTime<Image, CameraInfo, Image, CameraInfo>;

ApproximateTime MakeApproximateTime(const StereoSynchronizer::Settings& settings) {
  ApproximateTime policy(static_cast<unsigned>(settings.queue_size));
  if (settings.max_interval > 0.0) {
    policy.setMaxIntervalDuration(ros::Duration(settings.max_interval));
  }
  return policy;
}

}  // namespace

StereoSynchronizer::StereoSynchronizer(const Settings& settings, FrameCallback on_frame,
                                       ProblemCallback on_problem)
    : settings_(settings), on_frame_(std::move(on_frame)), on_problem_(std::move(on_problem)) {
  Reset();
}

StereoSynchronizer::~StereoSynchronizer() = default;

void StereoSynchronizer::Reset() {
  topics_.fill(Topic());
  if (settings_.approximate) {
    policy_ = std::make_unique<PolicyOver<Policy, ApproximateTime>>(
        MakeApproximateTime(settings_), this, &StereoSynchronizer::HandleFrame);
  } else {
    policy_ = std::make_unique<PolicyOver<Policy, ExactTime>>(
        ExactTime(static_cast<unsigned>(settings_.queue_size)), this,
        &StereoSynchronizer::HandleFrame);
  }
}

void StereoSynchronizer::AddLeftImage(const ImageConstPtr& message) {
  Add(kLeftImage, message, &Policy::AddLeftImage);
}

void StereoSynchronizer::AddLeftInfo(const CameraInfoConstPtr& message) {
  Add(kLeftInfo, message, &Policy::AddLeftInfo);
}

void StereoSynchronizer::AddRightImage(const ImageConstPtr& message) {
  Add(kRightImage, message, &Policy::AddRightImage);
}

void StereoSynchronizer::AddRightInfo(const CameraInfoConstPtr& message) {
  Add(kRightInfo, message, &Policy::AddRightInfo);
}

template <class MessagePtr>
void StereoSynchronizer::Add(std::size_t topic, const MessagePtr& message,
                             void (Policy::*add)(const MessagePtr&)) {
  const ros::Time& stamp = message->header.stamp;
  Note(topic, stamp);
  try {
    (policy_.get()->*add)(message);
  } catch (const std::exception& error) {
    // The policies subtract stamps, and a ros::Duration ends at 68 years.
    std::ostringstream text;
    text << kNames[topic] << " has the stamp " << stamp << ", which can't be compared with the "
         << "other inputs' (" << error.what() << "); expected one clock for all; correct the "
         << "clock of its publisher";
    Reset();
    on_problem_("clock", text.str());
  }
  ReportIfStuck();
}

void StereoSynchronizer::HandleFrame(const ImageConstPtr& left, const CameraInfoConstPtr& left_info,
                                     const ImageConstPtr& right,
                                     const CameraInfoConstPtr& right_info) {
  for (Topic& topic : topics_) topic.unpaired = 0;
  on_frame_({left, left_info, right, right_info, ros::WallTime::now()});
}

// Messages of one topic come in the order of their stamps. One that is older than the last means
// that time went back; what waits would never be paired and would push new messages out.
void StereoSynchronizer::Note(std::size_t topic, const ros::Time& stamp) {
  if (stamp < topics_[topic].newest) {
    std::ostringstream text;
    text << kNames[topic] << " went back in time from " << topics_[topic].newest << " to " << stamp
         << "; expected growing stamps; starting afresh, as for a bag played in a loop";
    Reset();
    on_problem_("time", text.str());
  }
  topics_[topic].newest = stamp;
  ++topics_[topic].unpaired;
  ++received_[topic];
}

void StereoSynchronizer::ReportIfStuck() {
  const int patience = 2 * settings_.queue_size;
  const auto fewer = [](const Topic& a, const Topic& b) { return a.unpaired < b.unpaired; };
  const Topic& busiest = *std::max_element(topics_.begin(), topics_.end(), fewer);
  if (busiest.unpaired < patience) return;
  const std::string missing = MissingTopics();
  if (missing.empty()) {
    on_problem_("pairing", UnequalStamps());
  } else {
    on_problem_(missing, missing);  // each side's silence is a problem of its own
  }
  for (Topic& topic : topics_) topic.unpaired = 0;
}

std::string StereoSynchronizer::MissingTopics() const {
  std::string silent;
  for (std::size_t i = 0; i < topics_.size(); ++i) {
    if (topics_[i].unpaired == 0) silent += (silent.empty() ? "" : ", ") + std::string(kNames[i]);
  }
  if (silent.empty()) return "";
  return "nothing arrives on " + silent +
         " while the other inputs do; expected all four of the pair; check its publisher, its "
         "name and the namespace (rostopic info)";
}

std::string StereoSynchronizer::UnequalStamps() const {
  std::ostringstream text;
  text << "no frame out of the last messages, their newest stamps are";
  for (std::size_t i = 0; i < topics_.size(); ++i) {
    text << (i == 0 ? " " : ", ") << topics_[i].newest << " (" << kNames[i] << ')';
  }
  if (settings_.approximate) {
    text << "; expected stamps within approximate_max_interval (" << settings_.max_interval
         << " s); raise it or queue_size, or trigger the cameras together";
  } else {
    text << "; expected equal stamps; trigger the cameras together or set approximate_sync";
  }
  return text.str();
}

}  // namespace stereo_sgmp
