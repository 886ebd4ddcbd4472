#ifndef STEREO_SGMP_PRIOR_PLANE_JUMP_KERNEL_H_
#define STEREO_SGMP_PRIOR_PLANE_JUMP_KERNEL_H_

#include <array>
#include <cstddef>
#include <cstdint>

namespace stereo_sgmp {

// A plane S along pixels p of a row, whose path steps lead to q. A step adds the same amount to S
// everywhere, so its jump S^(q) - S^(p) is the whole part of that or, where the fractions carry,
// one more.
struct PlaneRun {
  // S + 1/2 at the first pixel, and what it grows by from one pixel to the next: whole parts, and
  // fractions in units of 2^-32.
  std::int32_t whole;
  std::uint32_t fraction;
  std::int32_t slope_whole;
  std::uint32_t slope;
  std::uint32_t step;  // the fraction of what it grows by from p to q
  // Jumps without and with a carry.
  std::int32_t jump;
  std::int32_t jump_with_carry;

  // The jump from the i-th pixel.
  int JumpAt(int i) const {
    const std::uint32_t at_p = fraction + static_cast<std::uint32_t>(i) * slope;
    return at_p + step < at_p ? jump_with_carry : jump;
  }
};

// Pixels of a row that the kernel takes at a time.
inline constexpr int kMaxPlaneRun = 64;

// What planes do along a run of pixels p. Of the arrays only the first `cells` entries are set.
struct PlaneMoves {
  std::uint64_t alike;    // pixels, bit by bit, where all planes jump, by the same
  std::uint64_t several;  // where planes jump differently, and more than one does
  int cells;              // pixels where one plane jumps and others stay: that plane's Voronoi cell
  std::array<std::int32_t, kMaxPlaneRun> pixel;
  std::array<std::int32_t, kMaxPlaneRun> plane;
  std::array<std::int32_t, kMaxPlaneRun> begin;  // as JumpRow has it; empty where another plane
  std::array<std::int32_t, kMaxPlaneRun> end;    // stands for this one
};

// Follows `plane_count` planes, from one to PlaneSet::kMaxPlanes, through `count` <= kMaxPlaneRun
// pixels.
void FollowPlaneRuns(const PlaneRun* planes, int plane_count, int count, int disparities,
                     PlaneMoves* moves);

}  // namespace stereo_sgmp

#endif  // STEREO_SGMP_PRIOR_PLANE_JUMP_KERNEL_H_
