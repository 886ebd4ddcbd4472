#ifndef STEREO_SGMP_REFINEMENT_SPECKLE_H_
#define STEREO_SGMP_REFINEMENT_SPECKLE_H_

#include <cstdint>
#include <vector>

#include <opencv2/core.hpp>

namespace stereo_sgmp {

// Finds small islands in a disparity map. Keeps its buffers from call to call.
class SpeckleFilter {
 public:
  // Sets `reason` (CV_8U, InvalidReason) to kSpeckle for the valid pixels of each 4-connected
  // region of fewer than `size` valid pixels, whose neighbours differ by `range` pixels at most.
  // `disparity` is CV_32F. Does nothing for a size of 1 and below.
  void Mark(const cv::Mat& disparity, int size, double range, cv::Mat* reason);

 private:
  // A horizontal stretch of pixels [begin, end) of one region.
  struct Run {
    int y;
    int begin;
    int end;
  };

  void FindRuns(const cv::Mat& disparity, const cv::Mat& reason, float range, int y);
  void JoinRows(const cv::Mat& disparity, float range, std::int32_t above, std::int32_t row);
  void Join(std::int32_t run, std::int32_t other);
  std::int32_t RootOf(std::int32_t run);

  std::vector<Run> runs_;
  std::vector<std::int32_t> parents_;  // of runs; the root of a region is its own parent
  std::vector<std::int32_t> areas_;    // of regions, at their roots
};

}  // namespace stereo_sgmp

#endif  // STEREO_SGMP_REFINEMENT_SPECKLE_H_
