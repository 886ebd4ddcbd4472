// From a normal map to the shape of the disparity surface, up to its depth (paper, Sec. 3.4).
#ifndef STEREO_SGMP_PRIOR_NORMALS_NORMAL_INTEGRATION_H_
#define STEREO_SGMP_PRIOR_NORMALS_NORMAL_INTEGRATION_H_

#include <vector>

#include <opencv2/core.hpp>

#include "common/thread_pool.h"
#include "stereo_sgmp/stereo_camera.h"

namespace stereo_sgmp {

// delta = log(d + doffs) of the pixels, determined within each component up to a constant: the
// unknown depth of a surface scales its d + doffs. Pixels are of one component where a path of
// neighbours with known normals connects them within one cell of a grid: as in the paper's
// supplement each cell is integrated by itself.
struct IntegratedNormals {
  // Side and area of the largest cells, pixels.
  static constexpr int kCellSize = 64;
  static constexpr int kCellArea = kCellSize * kCellSize;
  // The cell that a component > 0 lies in.
  static int CellOf(int component) { return (component - 1) / kCellArea; }

  // A surface that goes on from component `from` to `to` of the next cell, where it has
  // delta + `offset` on the scale of `from`.
  struct Continuation {
    int from = 0;
    int to = 0;
    double offset = 0.0;
  };

  cv::Mat_<float> log_disparity;  // delta with mean 0 over each component; 0 where unknown
  cv::Mat_<int> component;        // > 0, the same in all pixels of a component; 0 where unknown
  std::vector<Continuation> continuations;  // both ways, in rising order of `from` and `to`
};

// `normals`: CV_32FC3, in the camera's frame (x right, y down, z forward); zero or not finite
// where unknown. Their lengths don't matter, nor does the side they point to as long as neighbours
// agree. `discontinuities`, if not empty, is CV_8U of the same size, 255 at both pixels beside a
// depth discontinuity: no surface is continued from one such pixel to another.
// Throws std::invalid_argument for other types and sizes, as StereoCamera::Check, and where no
// normal is known.
IntegratedNormals IntegrateNormals(const cv::Mat& normals, const cv::Mat& discontinuities,
                                   const StereoCamera& camera, ThreadPool* pool);

}  // namespace stereo_sgmp

#endif  // STEREO_SGMP_PRIOR_NORMALS_NORMAL_INTEGRATION_H_
