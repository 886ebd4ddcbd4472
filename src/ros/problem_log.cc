#include "ros/problem_log.h"

#include <iterator>

namespace stereo_sgmp {

bool ProblemLog::ShouldTell(const std::string& kind) {
  const ros::WallTime now = ros::WallTime::now();
  std::lock_guard<std::mutex> lock(mutex_);
  for (auto it = told_.begin(); it != told_.end();) {
    it = now - it->second >= period_ ? told_.erase(it) : std::next(it);
  }
  return told_.emplace(kind, now).second;
}

}  // namespace stereo_sgmp
