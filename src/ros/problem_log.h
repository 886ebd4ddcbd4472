#ifndef STEREO_SGMP_ROS_PROBLEM_LOG_H_
#define STEREO_SGMP_ROS_PROBLEM_LOG_H_

#include <map>
#include <mutex>
#include <string>

#include <ros/time.h>

namespace stereo_sgmp {

// Decides which of a stream of repeated problems are told: each kind at most once in a period.
// Unlike the throttled macros of rosconsole, a problem does not silence those of another kind,
// and simulated time that stands still does not silence all. Safe to call from several threads.
class ProblemLog {
 public:
  explicit ProblemLog(ros::WallDuration period) : period_(period) {}

  bool ShouldTell(const std::string& kind);

 private:
  const ros::WallDuration period_;
  std::mutex mutex_;
  std::map<std::string, ros::WallTime> told_;  // by kind, younger than the period
};

}  // namespace stereo_sgmp

#endif  // STEREO_SGMP_ROS_PROBLEM_LOG_H_
