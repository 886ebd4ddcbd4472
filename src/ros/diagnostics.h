#ifndef STEREO_SGMP_ROS_DIAGNOSTICS_H_
#define STEREO_SGMP_ROS_DIAGNOSTICS_H_

#include <cstdint>
#include <mutex>
#include <string>
#include <vector>

#include <diagnostic_updater/diagnostic_updater.h>
#include <ros/node_handle.h>
#include <ros/time.h>

#include "ros/input_watch.h"
#include "stereo_sgmp/Statistics.h"

namespace stereo_sgmp {

// The state of the nodelet on /diagnostics: inputs, frames (rates, latencies, drops), result
// (density, reasons of invalid pixels, planes, rows) and memory. NoteFrame and NoteRejection may
// come from another thread than the rest.
class Diagnostics {
 public:
  Diagnostics(const ros::NodeHandle& nh, const ros::NodeHandle& private_nh,
              const std::string& name);

  void NoteFrame(const stereo_sgmp::StatisticsConstPtr& statistics);
  void NoteRejection(const std::string& reason);

  // Publishes, as seldom as the parameter diagnostic_period says. `listening`: somebody wants
  // results.
  void Update(const std::vector<InputTopic>& inputs, bool listening);

 private:
  using Status = diagnostic_updater::DiagnosticStatusWrapper;

  void DescribeInputs(Status& status);
  void DescribeFrames(Status& status);
  void DescribeResult(Status& status);
  void DescribeMemory(Status& status);

  diagnostic_updater::Updater updater_;
  bool listening_ = false;
  std::vector<InputTopic> inputs_;
  std::vector<std::uint64_t> last_received_;  // of each input, at the last publication
  ros::WallTime next_update_;
  ros::WallTime last_inputs_;
  ros::WallTime last_frames_;
  std::uint64_t last_matched_ = 0;
  std::uint64_t last_dropped_ = 0;

  std::mutex mutex_;                            // guards the below
  stereo_sgmp::StatisticsConstPtr statistics_;  // of the last frame
  std::string rejection_;                       // since the last publication
};

}  // namespace stereo_sgmp

#endif  // STEREO_SGMP_ROS_DIAGNOSTICS_H_
