#include "ros/diagnostics.h"

#include <unistd.h>

#include <cstddef>
#include <fstream>
#include <numeric>
#include <utility>

#include <diagnostic_msgs/DiagnosticStatus.h>

namespace stereo_sgmp {
namespace {

using diagnostic_msgs::DiagnosticStatus;

constexpr double kSparse = 0.3;      // share of valid pixels that is worth a warning
constexpr double kLargeShift = 1.0;  // px between the rows of the images

const char* const kReasons[] = {"valid",      "range",      "border", "uncertainty",
                                "left-right", "uniqueness", "speckle"};

// Times a second since `last`, which becomes now; 0 at first.
double Rate(std::uint64_t count, double seconds) {
  return seconds > 0.0 ? static_cast<double>(count) / seconds : 0.0;
}

double SecondsSince(ros::WallTime* last) {
  const ros::WallTime now = ros::WallTime::now();
  const double seconds = last->isZero() ? 0.0 : (now - *last).toSec();
  *last = now;
  return seconds;
}

double ResidentMegabytes() {
  std::ifstream file("/proc/self/statm");
  double total = 0.0;
  double resident = 0.0;
  file >> total >> resident;
  return resident * static_cast<double>(sysconf(_SC_PAGESIZE)) / (1024.0 * 1024.0);
}

}  // namespace

Diagnostics::Diagnostics(const ros::NodeHandle& nh, const ros::NodeHandle& private_nh,
                         const std::string& name)
    : updater_(nh, private_nh, name) {
  updater_.setHardwareID("none");
  updater_.add("inputs", this, &Diagnostics::DescribeInputs);
  updater_.add("frames", this, &Diagnostics::DescribeFrames);
  updater_.add("result", this, &Diagnostics::DescribeResult);
  updater_.add("memory", this, &Diagnostics::DescribeMemory);
}

void Diagnostics::NoteFrame(const stereo_sgmp::StatisticsConstPtr& statistics) {
  std::lock_guard<std::mutex> lock(mutex_);
  statistics_ = statistics;
}

void Diagnostics::NoteRejection(const std::string& reason) {
  std::lock_guard<std::mutex> lock(mutex_);
  rejection_ = reason;
}

void Diagnostics::Update(const std::vector<InputTopic>& inputs, bool listening) {
  inputs_ = inputs;
  listening_ = listening;
  // By the wall clock: that of ROS goes back when a bag is played in a loop.
  const ros::WallTime now = ros::WallTime::now();
  if (now < next_update_) return;
  updater_.force_update();
  next_update_ = now + ros::WallDuration(updater_.getPeriod());
}

void Diagnostics::DescribeInputs(Status& status) {
  const double seconds = SecondsSince(&last_inputs_);
  last_received_.resize(inputs_.size());
  std::string silent;
  for (std::size_t i = 0; i < inputs_.size(); ++i) {
    const InputTopic& input = inputs_[i];
    const std::uint64_t news = input.received - last_received_[i];
    last_received_[i] = input.received;
    if (news == 0) silent += (silent.empty() ? "" : ", ") + input.name;
    status.addf(input.name, "%.1f Hz, %llu messages, %u publishers", Rate(news, seconds),
                static_cast<unsigned long long>(input.received), input.publishers);
  }
  if (!listening_) {
    status.summary(DiagnosticStatus::OK, "idle: nobody listens");
  } else if (silent.empty()) {
    status.summary(DiagnosticStatus::OK, "all inputs arrive");
  } else {
    status.summary(DiagnosticStatus::ERROR, "nothing arrives on " + silent);
  }
}

void Diagnostics::DescribeFrames(Status& status) {
  const double seconds = SecondsSince(&last_frames_);
  stereo_sgmp::StatisticsConstPtr frame;
  std::string rejection;
  {
    std::lock_guard<std::mutex> lock(mutex_);
    frame = statistics_;
    rejection = std::exchange(rejection_, "");
  }
  if (!frame) {
    const bool bad = !rejection.empty();
    status.summary(bad ? DiagnosticStatus::ERROR : DiagnosticStatus::OK,
                   bad ? rejection : "no frame yet");
    return;
  }
  const std::uint64_t matched = frame->frames - std::exchange(last_matched_, frame->frames);
  const std::uint64_t dropped = frame->dropped - std::exchange(last_dropped_, frame->dropped);
  status.summary(DiagnosticStatus::OK, "keeps up");
  if (dropped > 0) status.mergeSummary(DiagnosticStatus::WARN, "drops frames for newer ones");
  if (frame->load_level > 0) {
    status.mergeSummary(DiagnosticStatus::WARN, "gives up " + frame->load + " to keep the rate");
  }
  if (!rejection.empty()) status.mergeSummary(DiagnosticStatus::ERROR, rejection);
  status.addf("matched", "%.1f Hz", Rate(matched, seconds));
  status.addf("dropped", "%.1f Hz", Rate(dropped, seconds));
  status.add("frames matched", frame->frames);
  status.add("frames dropped", frame->dropped);
  status.add("frames refused", frame->rejected);
  status.add("given up", frame->load);
  status.addf("latency, arrival to disparity", "%.1f ms", frame->latency_ms);
  status.addf("latency, arrival to cloud", "%.1f ms", frame->cloud_latency_ms);
  status.addf("age, stamp to disparity", "%.1f ms", frame->age_ms);
  status.addf("matching", "%.1f ms", frame->frame_ms);
  for (const stereo_sgmp::Stage& stage : frame->stages) {
    status.addf("stage " + stage.name, "%.1f ms", stage.ms);
  }
}

void Diagnostics::DescribeResult(Status& status) {
  stereo_sgmp::StatisticsConstPtr frame;
  {
    std::lock_guard<std::mutex> lock(mutex_);
    frame = statistics_;
  }
  if (!frame) return status.summary(DiagnosticStatus::OK, "no frame yet");
  status.summary(DiagnosticStatus::OK, "pixels match");
  if (frame->density < kSparse) {
    status.summaryf(DiagnosticStatus::WARN, "only %.0f %% of the pixels match",
                    100.0 * frame->density);
  }
  if (frame->alignment_median_offset > kLargeShift) {
    status.mergeSummaryf(DiagnosticStatus::WARN, "rows differ by %.1f px",
                         frame->alignment_median_offset);
  }
  const double pixels = std::accumulate(frame->reasons.begin(), frame->reasons.end(), 0.0);
  for (std::size_t i = 0; i < frame->reasons.size(); ++i) {
    status.addf(i == 0 ? "valid pixels" : std::string("invalid: ") + kReasons[i], "%.1f %%",
                100.0 * frame->reasons[i] / pixels);
  }
  status.add("prior", frame->variant);
  status.add("planes", frame->planes);
  status.addf("rows apart, median", "%.2f px", frame->alignment_median_offset);
}

void Diagnostics::DescribeMemory(Status& status) {
  const double megabytes = ResidentMegabytes();
  status.summaryf(DiagnosticStatus::OK, "%.0f MB", megabytes);
  status.addf("resident memory of the process", "%.0f MB", megabytes);
}

}  // namespace stereo_sgmp
