#ifndef STEREO_SGMP_PRIOR_PLANE_JUMP_KERNEL_H_
#define STEREO_SGMP_PRIOR_PLANE_JUMP_KERNEL_H_

#include <cstdint>

namespace stereo_sgmp {

// A plane S along pixels p of a row, whose path steps lead to q. A step adds the same amount to S
// everywhere, so its jump S^(q) - S^(p) is the whole part of that or, where the fractions carry,
// one more.
struct PlaneRun {
  // Fractions in units of 2^-32: of S + 1/2 at the first pixel; what S grows by from one pixel to
  // the next; what it grows by from p to q.
  std::uint32_t fraction;
  std::uint32_t slope;
  std::uint32_t step;
  // Jumps without and with a carry.
  std::int32_t jump;
  std::int32_t jump_with_carry;
};

// Pixels of a row that the kernel takes at a time.
inline constexpr int kMaxPlaneRun = 64;

// The jumps of each plane at each of `count` <= kMaxPlaneRun pixels: plane k's at pixel i stands at
// jumps[k * kMaxPlaneRun + i], and bit i of moves[k] says whether it is one. Bit i of the result
// says whether the planes differ there.
std::uint64_t JumpsOfPlanes(const PlaneRun* planes, int plane_count, int count, std::int16_t* jumps,
                            std::uint64_t* moves);

}  // namespace stereo_sgmp

#endif  // STEREO_SGMP_PRIOR_PLANE_JUMP_KERNEL_H_
