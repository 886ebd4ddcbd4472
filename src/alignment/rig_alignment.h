#ifndef STEREO_SGMP_ALIGNMENT_RIG_ALIGNMENT_H_
#define STEREO_SGMP_ALIGNMENT_RIG_ALIGNMENT_H_

#include <deque>
#include <future>
#include <vector>

#include <opencv2/core.hpp>

#include "alignment/rectification_residual.h"
#include "stereo_sgmp/match_result.h"
#include "stereo_sgmp/options.h"

namespace stereo_sgmp {

// The rectification residual as a property of the rig: learnt from the matches of the first
// frames together, then refreshed beside the frames, each time as the median of the latest fits.
// A refresh begun at one frame is adopted a fixed number of frames later, so that the result
// depends on the sequence of frames only, never on time. Not safe to call from several threads.
class RigAlignment {
 public:
  // Learns from the pair (CV_8UC1, of one size) and says what to do with it: report.applied asks
  // for WarpRows(right, report.scale, report.offset). A change of size begins anew.
  AlignmentReport Update(const AlignmentOptions& options, const cv::Mat& left, const cv::Mat& right,
                         int min_disparity, int num_disparities);

  // Forgets the rig.
  void Reset();

 private:
  void LearnFirst(const cv::Mat& left, const cv::Mat& right, int min_disparity,
                  int num_disparities);
  void Refresh(int interval, const cv::Mat& left, const cv::Mat& right, int min_disparity,
               int num_disparities);
  void Adopt(const ResidualFit& fit);

  int frame_ = 0;
  cv::Size size_;
  std::vector<RowMatch> first_matches_;
  std::deque<ResidualFit> fits_;  // the latest reliable ones
  ResidualFit current_;
  std::future<ResidualFit> refresh_;
  int adopt_at_ = 0;
};

}  // namespace stereo_sgmp

#endif  // STEREO_SGMP_ALIGNMENT_RIG_ALIGNMENT_H_
