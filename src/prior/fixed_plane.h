// Disparity planes rounded to integers without rounding errors.
#ifndef STEREO_SGMP_PRIOR_FIXED_PLANE_H_
#define STEREO_SGMP_PRIOR_FIXED_PLANE_H_

#include <algorithm>
#include <cmath>
#include <cstdint>

#include "prior/plane_jump_kernel.h"
#include "stereo_sgmp/disparity_plane.h"

namespace stereo_sgmp {

// A plane with coefficients in 32.32 fixed point, so that S^ = round(S) is exact,
// the same on every machine, and unaffected by adding a whole number to the plane.
class FixedPlane {
 public:
  static constexpr int kFractionBits = 32;
  // Slopes beyond this, or disparities, are no surface a stereo pair could show.
  static constexpr double kMaxSlope = 1024.0;
  static constexpr double kMaxOffset = 16777216.0;

  FixedPlane() = default;
  explicit FixedPlane(const DisparityPlane& plane)
      : a_(ToFixed(plane.a)), b_(ToFixed(plane.b)), c_(ToFixed(plane.c) + kHalf) {}

  static bool Holds(const DisparityPlane& plane) {
    return std::abs(plane.a) <= kMaxSlope && std::abs(plane.b) <= kMaxSlope &&
           std::abs(plane.c) <= kMaxOffset;
  }

  // S^(x, y) = floor(S(x, y) + 1/2).
  int RoundedAt(int x, int y) const { return static_cast<int>(FixedAt(x, y) >> kFractionBits); }

  // S + 1/2 in units of 2^-32, whose whole part is S^; and what it grows by from x to x + 1.
  std::int64_t FixedAt(int x, int y) const { return a_ * x + b_ * y + c_; }
  std::int64_t FixedSlope() const { return a_; }

  // Whether S^ is the same at all pixels, so that no step has a jump.
  bool IsConstant() const { return a_ == 0 && b_ == 0; }

  bool IsParallelTo(const FixedPlane& plane) const { return a_ == plane.a_ && b_ == plane.b_; }

  // By how much a parallel plane is larger, in units of 2^-32.
  std::int64_t HeightOver(const FixedPlane& plane) const { return c_ - plane.c_; }

  // Along row y, from x on.
  PlaneRun RunFrom(int x, int y) const {
    const std::int64_t first = FixedAt(x, y);
    return {static_cast<std::int32_t>(first >> kFractionBits), static_cast<std::uint32_t>(first),
            static_cast<std::int32_t>(a_ >> kFractionBits), static_cast<std::uint32_t>(a_)};
  }

  // The step by (dx, dy), with jumps limited to +-limit.
  PlaneStep StepBy(int dx, int dy, int limit) const {
    const std::int64_t step = a_ * dx + b_ * dy;
    const std::int64_t whole = step >> kFractionBits;
    return {static_cast<std::uint32_t>(step),
            static_cast<std::int32_t>(std::clamp<std::int64_t>(whole, -limit, limit)),
            static_cast<std::int32_t>(std::clamp<std::int64_t>(whole + 1, -limit, limit))};
  }

 private:
  static constexpr std::int64_t kHalf = std::int64_t{1} << (kFractionBits - 1);

  static std::int64_t ToFixed(double value) {
    return std::llround(std::ldexp(value, kFractionBits));
  }

  std::int64_t a_ = 0;
  std::int64_t b_ = 0;
  std::int64_t c_ = kHalf;
};

}  // namespace stereo_sgmp

#endif  // STEREO_SGMP_PRIOR_FIXED_PLANE_H_
