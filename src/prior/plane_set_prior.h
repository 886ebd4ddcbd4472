// Overlapping planes as an orientation prior: 2D where a pixel has one plane, 3D where several.
#ifndef STEREO_SGMP_PRIOR_PLANE_SET_PRIOR_H_
#define STEREO_SGMP_PRIOR_PLANE_SET_PRIOR_H_

#include <cstdint>
#include <vector>

#include "cost/cost_rows.h"
#include "prior/fixed_plane.h"
#include "prior/orientation_prior.h"
#include "prior/plane_sets.h"
#include "stereo_sgmp/disparity_plane.h"
#include "stereo_sgmp/options.h"

namespace stereo_sgmp {

// Jumps of the nearest surfaces (paper, Sec. 3.3), with S~ the nearest of the rasterised surfaces,
// which is what the paper's forward and backward scans find.
//
// JumpPolicy::kSameSurface follows the surface k at p from p to q = p + r:
//   j_p(d) = S^_k(q) - S^_k(p), k = argmin |S^_k(p) - d|.
// JumpPolicy::kLiteral takes at q the surface nearest to the same d of those that hold at q:
//   j_p(d) = S^_d(q) - S^_d(p); 0 where either pixel has none.
// Jumps are limited to +- the number of disparities.
class PlaneSetPrior : public OrientationPrior {
 public:
  // `planes` are in pixels of the image that `shape` describes; `sets` refers to them and may be
  // smaller than the image. Copies what it needs and keeps its storage for the next call.
  // Throws std::invalid_argument where a plane is not finite or too steep, or `sets` is empty.
  void Assign(const std::vector<DisparityPlane>& planes, const PlaneSets& sets,
              const VolumeShape& shape, JumpPolicy policy);

  void Jumps(int y, int x_begin, int x_end, PathStep step, JumpRow* row) const override;

 private:
  // Pixels q of a row whose p all hold one set and, for the literal policy, whose q do.
  struct Stretch {
    int x_begin = 0;
    int x_end = 0;
    int y = 0;
    PathStep step;
    int entry = 0;  // of x_begin in the row
    const PlaneSet* at_p = nullptr;
    const PlaneSet* at_q = nullptr;
  };

  void MapColumns();
  const std::uint16_t* IdsOfRow(int y) const;
  int RunEnd(const std::uint16_t* ids, int x) const;
  const FixedPlane& PlaneOf(const PlaneSet& set, int k) const;

  void FillStretch(const Stretch& stretch, JumpRow* row) const;
  void FollowPlanes(const Stretch& stretch, JumpRow* row) const;
  void FollowLabels(const Stretch& stretch, JumpRow* row) const;

  VolumeShape shape_;
  JumpPolicy policy_ = JumpPolicy::kSameSurface;
  std::vector<FixedPlane> planes_;  // in disparity indices
  PlaneSets sets_;
  std::vector<std::int32_t> column_of_;     // per pixel column: its column of the set image
  std::vector<std::int32_t> column_begin_;  // per column of the set image: its first pixel's
};

}  // namespace stereo_sgmp

#endif  // STEREO_SGMP_PRIOR_PLANE_SET_PRIOR_H_
