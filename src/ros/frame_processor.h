#ifndef STEREO_SGMP_ROS_FRAME_PROCESSOR_H_
#define STEREO_SGMP_ROS_FRAME_PROCESSOR_H_

#include <atomic>
#include <cstdint>
#include <functional>
#include <mutex>
#include <optional>
#include <string>

#include <cv_bridge/cv_bridge.h>
#include <ros/time.h>

#include "ros/calibration_report.h"
#include "ros/color_images.h"
#include "ros/diagnostics.h"
#include "ros/follow_up_thread.h"
#include "ros/frame_matcher.h"
#include "ros/input_images.h"
#include "ros/outputs.h"
#include "ros/rig_watch.h"
#include "ros/stereo_frame.h"
#include "ros/stream_options.h"

namespace stereo_sgmp {

enum class Severity { kInfo, kWarning, kError };

// From frames to published results. All but SetOptions is of one thread; the cloud and what reports
// on the frame follow on another, beside the next frame.
class FrameProcessor {
 public:
  // Gets a sentence for people, and a name for its kind.
  using Tell =
      std::function<void(Severity severity, const std::string& kind, const std::string& text)>;

  // The pointers have to outlive this.
  FrameProcessor(const NodeletOptions& options, Outputs* outputs, const ColorImages* colors,
                 Diagnostics* diagnostics, Tell tell);

  // Takes effect with the next frame. From any thread.
  void SetOptions(const NodeletOptions& options);

  // `dropped`: frames given up so far. Does not throw: a frame that can't be matched is told of.
  void Process(const StereoFrame& frame, std::uint64_t dropped);

 private:
  void MatchAndPublish(const StereoFrame& frame, std::uint64_t dropped);
  void CheckRig(const StereoFrame& frame, const InputPair& images, const StereoCamera& camera);
  void FollowUp(const MatchedFrame& matched, const CloudStreamOptions& cloud,
                sensor_msgs::ImageConstPtr color, const cv_bridge::CvImageConstPtr& left,
                const ros::WallTime& arrival, const stereo_sgmp::StatisticsPtr& statistics);
  void PublishBaseline(const MatchedFrame& matched, const InputPair& images);
  stereo_sgmp::StatisticsPtr MakeStatistics(const MatchedFrame& matched,
                                            const ros::WallTime& arrival,
                                            std::uint64_t dropped) const;
  void RejectErrors(const std::function<void()>& work);
  void Reject(const std::string& kind, const std::string& problem);
  cv_bridge::CvImageConstPtr CloudColor(const sensor_msgs::ImageConstPtr& color,
                                        const cv_bridge::CvImageConstPtr& left) const;
  void TakeNewOptions();

  Outputs* const outputs_;
  const ColorImages* const colors_;
  Diagnostics* const diagnostics_;
  const Tell tell_;

  std::mutex options_mutex_;  // guards the one below
  std::optional<NodeletOptions> new_options_;

  FrameMatcher matcher_;
  CalibrationLog calibration_log_;
  RigWatch rig_watch_;
  std::uint64_t matched_ = 0;
  std::atomic<std::uint64_t> rejected_{0};

  FollowUpThread follow_up_;  // last: it uses all of the above
};

}  // namespace stereo_sgmp

#endif  // STEREO_SGMP_ROS_FRAME_PROCESSOR_H_
