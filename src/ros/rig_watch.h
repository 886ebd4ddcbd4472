#ifndef STEREO_SGMP_ROS_RIG_WATCH_H_
#define STEREO_SGMP_ROS_RIG_WATCH_H_

#include <string>
#include <vector>

#include <opencv2/core.hpp>

#include "stereo_sgmp/match_result.h"
#include "stereo_sgmp/options.h"

namespace stereo_sgmp {

struct RigProblem {
  std::string kind;
  std::string text;  // value, expectation and remedy
};

// Looks at the results of a stream for signs of a rig that does not fit its calibration: rows that
// differ between the images, and left and right exchanged.
class RigWatch {
 public:
  // After the match of a pair. Only where much does not match, and then in every 30th frame at
  // most, it takes more than a look at the statistics.
  std::vector<RigProblem> Check(const cv::Mat& left, const cv::Mat& right, const Options& options,
                                const MatchStatistics& statistics);

 private:
  static constexpr int kCheckInterval = 30;  // frames

  int frames_since_check_ = kCheckInterval;
  bool swapped_ = false;  // as it looked last
};

}  // namespace stereo_sgmp

#endif  // STEREO_SGMP_ROS_RIG_WATCH_H_
