// Disparity planes rounded to integers without rounding errors.
#ifndef STEREO_SGMP_PRIOR_FIXED_PLANE_H_
#define STEREO_SGMP_PRIOR_FIXED_PLANE_H_

#include <algorithm>
#include <cmath>
#include <cstdint>

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
  int RoundedAt(int x, int y) const { return static_cast<int>(Value(x, y) >> kFractionBits); }

  // The jumps S^(x + dx, y + dy) - S^(x, y) for `count` pixels from x on. A step adds the same
  // amount to S everywhere, so its jump is the whole part of that or, where the fractions carry,
  // one more. Limited to +-limit.
  void Jumps(int x, int y, int dx, int dy, int count, int limit, std::int16_t* jumps) const {
    const std::int64_t step = a_ * dx + b_ * dy;
    const auto whole = step >> kFractionBits;
    const auto bounded = [limit](std::int64_t jump) {
      return static_cast<int>(std::clamp<std::int64_t>(jump, -limit, limit));
    };
    const int below = bounded(whole);
    const int above = bounded(whole + 1) - below;
    const auto step_fraction = static_cast<std::uint32_t>(step);
    const auto slope_fraction = static_cast<std::uint32_t>(a_);
    const auto fraction = static_cast<std::uint32_t>(Value(x, y));
    for (int i = 0; i < count; ++i) {
      const std::uint32_t at_p = fraction + slope_fraction * static_cast<std::uint32_t>(i);
      const std::uint32_t at_q = at_p + step_fraction;
      jumps[i] = static_cast<std::int16_t>(below + (at_q < at_p ? above : 0));
    }
  }

 private:
  static constexpr std::int64_t kHalf = std::int64_t{1} << (kFractionBits - 1);

  static std::int64_t ToFixed(double value) {
    return std::llround(std::ldexp(value, kFractionBits));
  }
  std::int64_t Value(int x, int y) const { return a_ * x + b_ * y + c_; }

  std::int64_t a_ = 0;
  std::int64_t b_ = 0;
  std::int64_t c_ = kHalf;
};

}  // namespace stereo_sgmp

#endif  // STEREO_SGMP_PRIOR_FIXED_PLANE_H_
