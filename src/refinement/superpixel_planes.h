#ifndef STEREO_SGMP_REFINEMENT_SUPERPIXEL_PLANES_H_
#define STEREO_SGMP_REFINEMENT_SUPERPIXEL_PLANES_H_

#include <cstdint>
#include <optional>
#include <vector>

#include <opencv2/core.hpp>

#include "common/thread_pool.h"
#include "cost/cost_rows.h"
#include "stereo_sgmp/disparity_plane.h"

namespace stereo_sgmp {

// Fills holes with the plane of their superpixel. Each superpixel with enough valid pixels, of
// which at least half lie on one plane (RANSAC, then least squares over the inliers), has one.
// Keeps its buffers from call to call.
class SuperpixelPlanes {
 public:
  // Superpixels are found in an image of half the size: enough to tell surfaces apart, and every
  // second pixel of every second row is enough to fit planes to.
  static constexpr int kLabelScale = 2;
  static cv::Size LabelSize(cv::Size size) {
    return {(size.width + kLabelScale - 1) / kLabelScale,
            (size.height + kLabelScale - 1) / kLabelScale};
  }

  // Pixels that are not valid take the value of the plane and become valid, unless it lies
  // outside the disparities of `shape`.
  // `labels`: CV_32S, 0 ... count - 1, of LabelSize(); pixel (x, y) has that of
  // (x / kLabelScale, y / kLabelScale). `disparity`: CV_32F. `valid`: CV_8U, not 0 = valid, 255
  // where a plane was taken. Results do not depend on the number of threads.
  void Apply(const cv::Mat& labels, int count, const VolumeShape& shape, cv::Mat* disparity,
             cv::Mat* valid, ThreadPool* pool);

 private:
  void GroupValidPixels(const cv::Mat& labels, int count, const cv::Mat& disparity,
                        const cv::Mat& valid);
  std::optional<DisparityPlane> FitPlane(int label) const;
  void FillRow(const std::int32_t* labels, const VolumeShape& shape, int y, float* disparity,
               std::uint8_t* valid) const;

  // The valid sampled pixels of superpixel k are the entries first_[k] ... first_[k + 1] - 1.
  std::vector<int> first_;
  std::vector<int> next_;  // while grouping: where the next pixel of each superpixel goes
  std::vector<float> x_;
  std::vector<float> y_;
  std::vector<float> d_;
  std::vector<std::optional<DisparityPlane>> planes_;
};

}  // namespace stereo_sgmp

#endif  // STEREO_SGMP_REFINEMENT_SUPERPIXEL_PLANES_H_
