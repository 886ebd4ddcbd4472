#ifndef STEREO_SGMP_PRIOR_PHASED_PLANE_KERNEL_H_
#define STEREO_SGMP_PRIOR_PHASED_PLANE_KERNEL_H_

#include <cstdint>

#include "prior/plane_jump_kernel.h"

namespace stereo_sgmp {

// A plane and its copies below and above it (SteeringPlanes) along pixels p of a row. As they are
// half a disparity away at most, these planes round to one disparity or to two neighbours, with a
// Voronoi cell each.
struct PhasedPlaneRun {
  PlaneRun plane;
  std::uint32_t below;  // how far the copies are away, in units of 2^-32, up to 2^31; 0 for none
  std::uint32_t above;
  int count;  // of pixels, up to kMaxPlaneRun
  int disparities;
};

// What they do on one step.
struct PhasedPlaneMoves {
  PlaneStep step;
  std::uint64_t pixels;  // bit by bit, from which pixels it is asked for
  // The entries of a JumpRow at which the step from the first pixel ends. Whole vectors are
  // written, up to JumpEntries::kVector - 1 entries too many; pixels that are not asked for get no
  // jump.
  std::int16_t* jump;
  std::int16_t* begin;
  std::int16_t* end;
  // Where both cells jump, by different numbers: the entry gets no jump.
  std::uint64_t several;
};

// Fills the moves of all steps, up to kMaxPlaneSteps.
void FollowPhasedPlane(const PhasedPlaneRun& run, int step_count, PhasedPlaneMoves* moves);

}  // namespace stereo_sgmp

#endif  // STEREO_SGMP_PRIOR_PHASED_PLANE_KERNEL_H_
