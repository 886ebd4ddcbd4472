#ifndef STEREO_SGMP_PRIOR_PLANE_JUMP_KERNEL_H_
#define STEREO_SGMP_PRIOR_PLANE_JUMP_KERNEL_H_

#include <array>
#include <cstddef>
#include <cstdint>

namespace stereo_sgmp {

// A plane S along pixels p of a row: S + 1/2 at the first one, and what it grows by from one to the
// next; whole parts, and fractions in units of 2^-32.
struct PlaneRun {
  std::int32_t whole;
  std::uint32_t fraction;
  std::int32_t slope_whole;
  std::uint32_t slope;
};

// A path step from p to q. It adds the same amount to S everywhere, so its jump S^(q) - S^(p) is
// the whole part of that or, where the fractions carry, one more.
struct PlaneStep {
  std::uint32_t fraction;
  std::int32_t jump;
  std::int32_t jump_with_carry;

  // The jump from a pixel where S + 1/2 has this fraction.
  int JumpFrom(std::uint32_t at_p) const { return at_p + fraction < at_p ? jump_with_carry : jump; }

  // The jump from the i-th pixel of the run.
  int JumpAt(const PlaneRun& run, int i) const {
    return JumpFrom(run.fraction + static_cast<std::uint32_t>(i) * run.slope);
  }
};

// Pixels of a row, and steps from each, that the kernel takes at a time.
inline constexpr int kMaxPlaneRun = 64;
inline constexpr int kMaxPlaneSteps = 3;

// Planes along a run of pixels p.
struct PlaneRuns {
  const PlaneRun* planes;
  int plane_count;             // from one to PlaneSet::kMaxPlanes
  const std::uint8_t* moving;  // those that are not constant, rising; the others never jump
  int moving_count;
  int count;  // of pixels, up to kMaxPlaneRun
  int disparities;

  const PlaneStep* const* steps;  // of each step, by the number of the plane
  const std::int16_t* numbers;    // of the planes
  int step_count;                 // up to kMaxPlaneSteps
  const std::uint64_t* pixels;    // of each step, bit by bit, from which pixels it is asked for

  const PlaneStep& StepOf(int step, int plane) const { return steps[step][numbers[plane]]; }
  int JumpAt(int step, int plane, int i) const {
    return StepOf(step, plane).JumpAt(planes[plane], i);
  }
};

// What planes do on these steps. Of the arrays only the first entries are set.
struct PlaneMoves {
  // Of each step, bit by bit: pixels where all planes jump, by the same; where planes jump
  // differently, and more than one does.
  std::array<std::uint64_t, kMaxPlaneSteps> alike;
  std::array<std::uint64_t, kMaxPlaneSteps> several;
  // Pixels where one plane jumps and others stay, for each step up to its cells_end: the jump and
  // the Voronoi cell of that plane as JumpRow has it; no jump where another plane stands for it.
  std::array<int, kMaxPlaneSteps> cells_end;
  static constexpr int kMostCells = kMaxPlaneSteps * kMaxPlaneRun;
  std::array<std::int32_t, kMostCells> pixel;
  std::array<std::int32_t, kMostCells> plane;
  std::array<std::int32_t, kMostCells> jump;
  std::array<std::int32_t, kMostCells> begin;
  std::array<std::int32_t, kMostCells> end;
};

void FollowPlaneRuns(const PlaneRuns& runs, PlaneMoves* moves);

}  // namespace stereo_sgmp

#endif  // STEREO_SGMP_PRIOR_PLANE_JUMP_KERNEL_H_
