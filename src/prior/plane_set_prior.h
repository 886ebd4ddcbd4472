// Overlapping planes as an orientation prior: 2D where a pixel has one plane, 3D where several.
#ifndef STEREO_SGMP_PRIOR_PLANE_SET_PRIOR_H_
#define STEREO_SGMP_PRIOR_PLANE_SET_PRIOR_H_

#include <array>
#include <cstdint>
#include <vector>

#include "cost/cost_rows.h"
#include "prior/fixed_plane.h"
#include "prior/orientation_prior.h"
#include "prior/plane_jump_kernel.h"
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
  void JumpsOfSteps(int y, int x_begin, int x_end, const PathStep* steps, int count,
                    JumpRow* rows) const override;

 private:
  // The steps that are asked for: those to the pixels q of row y from `begin` to `end`.
  struct Question {
    int y = 0;
    int begin = 0;
    int end = 0;
    const PathStep* steps = nullptr;  // of one dy
    int step_count = 0;
    JumpRow* rows = nullptr;
    int first_x = 0;  // of the entries of the rows
  };

  // Of the planes of a set, by their place in it, those that are not constant; and whether they are
  // one with its copies, as PhasedPlaneRun has them.
  struct MovingPlanes {
    std::uint8_t count = 0;
    std::array<std::uint8_t, PlaneSet::kMaxPlanes> places{};
    bool is_phased = false;
    std::uint32_t below = 0;
    std::uint32_t above = 0;
  };

  using StepBits = std::array<std::uint64_t, kMaxPlaneSteps>;  // pixels of each step, as bits

  // Pixel columns with one set.
  struct Run {
    int begin = 0;
    int end = 0;
    std::uint16_t set = 0;
  };

  void FindMoving();
  void FindPhases(const PlaneSet& set, MovingPlanes* moving) const;
  void MapColumns();
  void MapRows();
  void MapRuns();
  std::size_t SetAt(int x, int row) const;
  int RunEnd(int x, int row) const;
  const FixedPlane& PlaneOf(const PlaneSet& set, int k) const;

  void FollowSurfaces(const Question& question) const;
  void FollowLabels(const Question& question) const;
  void FollowNearest(const Question& question, const PlaneSet& at_p, const PlaneSet& at_q) const;
  void FollowAnyRun(const Question& question, std::size_t set, int x_p, int count) const;
  void FollowPhases(const Question& question, std::size_t set_id, int x_p, int count) const;
  void FollowRun(const Question& question, std::size_t set_id, int x_p, int count) const;
  std::uint64_t PixelsAsked(const Question& question, PathStep step, int x_p, int count) const;
  void WriteSeveral(const Question& question, const PlaneSet& set, int x_p,
                    const StepBits& several) const;

  VolumeShape shape_;
  JumpPolicy policy_ = JumpPolicy::kSameSurface;
  std::vector<FixedPlane> planes_;               // in disparity indices
  std::array<std::vector<PlaneStep>, 9> steps_;  // of each plane, to each neighbour of a pixel
  PlaneSets sets_;
  std::vector<MovingPlanes> moving_;        // of each set
  std::vector<std::int32_t> column_of_;     // per pixel column: its column of the set image
  std::vector<std::int32_t> row_of_;        // per pixel row: its row of the set image
  std::vector<std::int32_t> column_begin_;  // per column of the set image: its first pixel's
  // Where planes move, the runs of the rows of the set image: those of row i up to runs_end_[i].
  std::vector<Run> runs_;
  std::vector<std::size_t> runs_end_;
};

}  // namespace stereo_sgmp

#endif  // STEREO_SGMP_PRIOR_PLANE_SET_PRIOR_H_
