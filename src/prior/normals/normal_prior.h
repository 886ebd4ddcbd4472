// Surface normals as an orientation prior: SGM-GNv and SGM-GNi of the paper.
#ifndef STEREO_SGMP_PRIOR_NORMALS_NORMAL_PRIOR_H_
#define STEREO_SGMP_PRIOR_NORMALS_NORMAL_PRIOR_H_

#include <array>
#include <cstddef>
#include <cstdint>
#include <optional>

#include <opencv2/core.hpp>

#include "common/thread_pool.h"
#include "cost/cost_rows.h"
#include "prior/normals/surface_family.h"
#include "prior/orientation_prior.h"
#include "prior/plane_hypotheses.h"
#include "prior/surface_prior.h"
#include "stereo_sgmp/stereo_camera.h"

namespace stereo_sgmp {

// Jumps along the surfaces of a family (paper, Sec. 3.3), with S^ = floor(S + 1/2):
//   j_p(d) = S^_k(q) - S^_k(p), k = argmin |S^_k(p) - d|, the lower k where two are as near;
// Limited to +- the number of disparities. A family of one surface makes a 2D prior. Where p and q
// are of two components of one cell, between which there is a step in depth or normals say nothing,
// all disparities take the jump of the placed surface; 0 without one, and from cell to cell.
class NormalPrior : public OrientationPrior {
 public:
  // `placed`, if not empty, as PlacedSurfaces::disparity. Throws std::invalid_argument where the
  // family or the surface is not of the size of `shape`.
  void Assign(SurfaceFamily family, const cv::Mat& placed, const VolumeShape& shape);

  void Jumps(int y, int x_begin, int x_end, PathStep step, JumpRow* row) const override;

 private:
  static constexpr int kMaxStretch = 64;
  template <typename T>
  using PerPixel = std::array<T, kMaxStretch>;

  // Pixels of a row.
  struct Stretch {
    const float* shape_p = nullptr;  // e(p)
    const float* shape_q = nullptr;
    int count = 0;
    int entry = 0;           // of the first pixel in the row
    PerPixel<int> joined{};  // -1 where p and q are of one component, else 0
  };
  // What the surfaces [begin, end) do in a stretch.
  struct Steps {
    std::size_t begin = 0;
    std::size_t end = 0;
    std::array<PerPixel<std::int16_t>, SurfaceFamily::kMaxSurfaces> at_p;  // S^_k(p), indices
    std::array<PerPixel<std::int16_t>, SurfaceFamily::kMaxSurfaces> jump;
    PerPixel<int> differ;  // not 0 where not all jumps are the same
  };

  static bool Join(const int* component_p, const int* component_q, Stretch* stretch);
  void CrossBorders(int y, int x_begin, int x_end, PathStep step, std::int16_t* jump) const;
  void FindReached(const Stretch& stretch, Steps* steps) const;
  void Follow(const Stretch& stretch, Steps* steps) const;
  void Write(const Stretch& stretch, const Steps& steps, JumpRow* row) const;
  void Rasterize(float scale, const float* shape, std::size_t count, PerPixel<int>* index) const;
  int IndexOf(float scale, float e) const;

  VolumeShape shape_;
  SurfaceFamily family_;
  std::optional<SurfacePrior> placed_;
};

// How SGM-GNv and SGM-GNi make their surfaces.
struct NormalPriorSettings {
  bool all_depths = true;  // GNv; otherwise GNi
  double disparity = 0.0;  // GNi: the surface's mean disparity, pixels; 0: middle of the range
};

// Makes the prior of a frame; keeps it for the next.
class NormalPriorBuilder {
 public:
  // `normals` and `discontinuities` as IntegrateNormals takes them, of the size of `shape`; for
  // GNv, `coarse` and `left` are what the surfaces are placed by, see PlaceSurfaces. The result is
  // valid until the next call. Throws std::invalid_argument as IntegrateNormals and where the
  // search range lies behind the camera or the sizes differ.
  const OrientationPrior* Build(const NormalPriorSettings& settings, const cv::Mat& normals,
                                const cv::Mat& discontinuities, const StereoCamera& camera,
                                const CoarseDisparity& coarse, const cv::Mat& left,
                                const VolumeShape& shape, ThreadPool* pool);

 private:
  NormalPrior prior_;
};

}  // namespace stereo_sgmp

#endif  // STEREO_SGMP_PRIOR_NORMALS_NORMAL_PRIOR_H_
