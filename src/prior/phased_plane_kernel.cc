#include "prior/phased_plane_kernel.h"

#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "prior/phased_plane_kernel.cc"
#include <hwy/foreach_target.h>

#include <hwy/highway.h>

#include <cstring>

#include "prior/orientation_prior.h"
#include "prior/plane_vectors-inl.h"

HWY_BEFORE_NAMESPACE();
namespace stereo_sgmp {
namespace HWY_NAMESPACE {
namespace hn = hwy::HWY_NAMESPACE;

HWY_INLINE hn::Mask<Signed> MaskOf(std::uint64_t bits) {
  std::uint8_t bytes[sizeof(bits)];
  std::memcpy(bytes, &bits, sizeof(bits));
  return hn::LoadMaskBits(Signed(), bytes);
}

// Where the whole part of `fraction` + `added` is 1.
HWY_INLINE hn::Mask<Signed> Carries(VU fraction, VU added) {
  return hn::RebindMask(Signed(), hn::Lt(hn::Add(fraction, added), fraction));
}

// S + 1/2 along a vector of pixels.
struct PlaneVector {
  VU fraction;
  VS whole;
};

// The next pixels.
HWY_INLINE void Advance(const PlaneRun& plane, PlaneVector* at) {
  const Unsigned d;
  const Signed ds;
  const std::uint64_t stride = std::uint64_t{plane.slope} * hn::Lanes(d);
  const std::int32_t whole = plane.slope_whole * static_cast<std::int32_t>(hn::Lanes(d)) +
                             static_cast<std::int32_t>(stride >> 32);
  const VU fraction = hn::Set(d, static_cast<std::uint32_t>(stride));
  const VS carry = hn::VecFromMask(ds, Carries(at->fraction, fraction));  // -1
  at->whole = hn::Sub(hn::Add(at->whole, hn::Set(ds, whole)), carry);
  at->fraction = hn::Add(at->fraction, fraction);
}

// The cells of the lower and the upper of two disparities that the planes round to, with the first
// plane that rounds to each; where all round to one, that has both.
struct Cells {
  VU lower;  // the fraction of its plane
  VU upper;
  VS border;  // the first disparity of the upper cell, within the range
};

HWY_INLINE Cells CellsAt(const PhasedPlaneRun& run, const PlaneVector& at) {
  const Unsigned d;
  const Signed ds;
  const VU below = hn::Set(d, run.below);
  const VU above = hn::Set(d, run.above);
  const auto copy_is_lower = hn::Lt(at.fraction, below);
  const auto copy_is_upper = hn::RebindMask(d, Carries(at.fraction, above));
  const VS one = hn::Set(ds, 1);
  const VS border = hn::Add(at.whole, hn::IfThenZeroElse(hn::RebindMask(ds, copy_is_lower), one));
  return {hn::IfThenElse(copy_is_lower, hn::Sub(at.fraction, below), at.fraction),
          hn::IfThenElse(copy_is_upper, hn::Add(at.fraction, above), at.fraction),
          hn::Min(hn::Max(border, hn::Zero(ds)), hn::Set(ds, run.disparities))};
}

HWY_INLINE VS JumpOf(const PlaneStep& step, VU fraction) {
  const Signed d;
  return hn::IfThenElse(Carries(fraction, hn::Set(Unsigned(), step.fraction)),
                        hn::Set(d, step.jump_with_carry), hn::Set(d, step.jump));
}

// Of the pixels from the i-th on.
HWY_INLINE void Follow(const Cells& cells, int disparities, int i, PhasedPlaneMoves* moves) {
  const Signed d;
  const hn::Rebind<std::int16_t, Signed> d16;
  const VS zero = hn::Zero(d);
  // A cell out of the range moves with the other.
  const VS upper_jump = JumpOf(moves->step, cells.upper);
  const VS lower =
      hn::IfThenElse(hn::Gt(cells.border, zero), JumpOf(moves->step, cells.lower), upper_jump);
  const VS upper = hn::IfThenElse(hn::Lt(cells.border, hn::Set(d, disparities)), upper_jump, lower);
  const auto lower_stays = hn::Eq(lower, zero);
  const auto is_one = hn::Or(hn::Eq(lower, upper), hn::Or(lower_stays, hn::Eq(upper, zero)));
  const auto reaches_end = hn::Or(hn::Eq(lower, upper), lower_stays);
  const auto pixels = MaskOf(moves->pixels >> i);
  const VS jump = hn::IfThenElse(lower_stays, upper, lower);
  const VS begin = hn::IfThenElseZero(lower_stays, cells.border);
  const VS end = hn::IfThenElse(reaches_end, hn::Set(d, JumpRow::kNoEnd), cells.border);
  const VS asked = hn::IfThenElseZero(hn::And(pixels, is_one), jump);
  hn::StoreU(hn::DemoteTo(d16, asked), d16, moves->jump + i);
  hn::StoreU(hn::DemoteTo(d16, begin), d16, moves->begin + i);
  hn::StoreU(hn::DemoteTo(d16, end), d16, moves->end + i);
  moves->several |= BitsOf(d, hn::AndNot(is_one, pixels)) << i;
}

template <int kSteps>
HWY_INLINE void FollowSteps(const PhasedPlaneRun& run, PhasedPlaneMoves* moves) {
  const VU first = hn::Iota(Unsigned(), 0U);
  PlaneVector at{FractionsAt(run.plane, first), ValuesAt(run.plane, first)};
  for (int s = 0; s < kSteps; ++s) moves[s].several = 0;
  for (int i = 0; i < run.count; i += static_cast<int>(hn::Lanes(Unsigned()))) {
    const Cells cells = CellsAt(run, at);
    for (int s = 0; s < kSteps; ++s) Follow(cells, run.disparities, i, moves + s);
    Advance(run.plane, &at);
  }
}

void FollowOnTarget(const PhasedPlaneRun& run, int step_count, PhasedPlaneMoves* moves) {
  static_assert(kMaxPlaneSteps == 3, "one case for each number of steps");
  switch (step_count) {
    case 1:
      return FollowSteps<1>(run, moves);
    case 2:
      return FollowSteps<2>(run, moves);
    default:
      return FollowSteps<3>(run, moves);
  }
}

}  // namespace HWY_NAMESPACE
}  // namespace stereo_sgmp
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace stereo_sgmp {

HWY_EXPORT(FollowOnTarget);

void FollowPhasedPlane(const PhasedPlaneRun& run, int step_count, PhasedPlaneMoves* moves) {
  HWY_DYNAMIC_DISPATCH(FollowOnTarget)(run, step_count, moves);
}

}  // namespace stereo_sgmp
#endif  // HWY_ONCE
