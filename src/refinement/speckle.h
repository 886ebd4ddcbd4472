#ifndef STEREO_SGMP_REFINEMENT_SPECKLE_H_
#define STEREO_SGMP_REFINEMENT_SPECKLE_H_

#include <cstdint>
#include <vector>

#include <opencv2/core.hpp>

#include "common/thread_pool.h"

namespace stereo_sgmp {

// Finds small islands in a disparity map. Keeps its buffers from call to call.
class SpeckleFilter {
 public:
  // Sets `reason` (CV_8U, InvalidReason) to kSpeckle for the valid pixels of each 4-connected
  // region of fewer than `size` valid pixels, whose neighbours differ by `range` pixels at most.
  // `disparity` is CV_32F. Does nothing for a size of 1 and below.
  void Mark(const cv::Mat& disparity, int size, double range, cv::Mat* reason, ThreadPool* pool);

 private:
  // A horizontal stretch of pixels [begin, end) of one region.
  struct Run {
    int y;
    int begin;
    int end;
  };

  // The regions of some rows.
  struct Regions {
    std::vector<Run> runs;
    std::vector<std::int32_t> parents;  // of runs; the root of a region is its own parent
    std::vector<std::int32_t> areas;    // of regions, at their roots
    // The runs of the first row are [0, first_row_end), of the last [last_row_begin, the end).
    std::int32_t first_row_end = 0;
    std::int32_t last_row_begin = 0;

    void Find(const cv::Mat& disparity, const cv::Mat& reason, float range, int y_begin, int y_end);
    void FindRuns(const cv::Mat& disparity, const cv::Mat& reason, float range, int y);
    // Joins those of the runs [above, above_end) of a row and [row, row_end) of the next that
    // touch at a small step.
    void JoinRows(const cv::Mat& disparity, float range, std::int32_t above, std::int32_t above_end,
                  std::int32_t row, std::int32_t row_end);
    void Join(std::int32_t run, std::int32_t other);
    std::int32_t RootOf(std::int32_t run);  // shortens the way to it
    std::int32_t FindRoot(std::int32_t run) const;
    std::int32_t Count() const { return static_cast<std::int32_t>(runs.size()); }
  };

  // The regions of all bands as regions of one image.
  void Gather(const cv::Mat& disparity, float range, ThreadPool* pool);
  void CopyBand(std::size_t band, std::int32_t offset);

  std::vector<Regions> bands_;  // of the image, one for each thread
  std::vector<std::int32_t> offsets_;
  Regions all_;
};

}  // namespace stereo_sgmp

#endif  // STEREO_SGMP_REFINEMENT_SPECKLE_H_
