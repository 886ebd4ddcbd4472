#include "prior/plane_jump_kernel.h"

#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "prior/plane_jump_kernel.cc"
#include <hwy/foreach_target.h>

#include <hwy/highway.h>

#include <cstddef>

#include "prior/plane_sets.h"

HWY_BEFORE_NAMESPACE();
namespace stereo_sgmp {
namespace HWY_NAMESPACE {
namespace hn = hwy::HWY_NAMESPACE;

using Unsigned = hn::ScalableTag<std::uint32_t>;
using Signed = hn::RebindToSigned<Unsigned>;
using VU = hn::Vec<Unsigned>;
using VS = hn::Vec<Signed>;

// Beyond the rounded disparity of any plane; sums of two such numbers still fit.
inline constexpr std::int32_t kFar = 1 << 30;

// The fraction of S + 1/2 after `steps` pixels.
HWY_INLINE VU FractionsAt(const PlaneRun& plane, VU steps) {
  const Unsigned d;
  return hn::Add(hn::Set(d, plane.fraction), hn::Mul(steps, hn::Set(d, plane.slope)));
}

template <class Mask>
HWY_INLINE std::uint64_t BitsOf(Mask mask) {
  std::uint8_t bits[8] = {};
  const std::size_t bytes = hn::StoreMaskBits(Unsigned(), mask, bits);
  std::uint64_t all = 0;
  for (std::size_t b = 0; b < bytes; ++b) all |= std::uint64_t{bits[b]} << (8 * b);
  return all;
}

// Bit by bit, at which of `count` pixels the fraction carries on the step to q.
HWY_INLINE std::uint64_t CarriesOf(const PlaneRun& plane, int count) {
  const Unsigned d;
  const int lanes = static_cast<int>(hn::Lanes(d));
  const VU step = hn::Set(d, plane.step);
  const VU stride = hn::Set(d, plane.slope * static_cast<std::uint32_t>(lanes));
  VU at_p = FractionsAt(plane, hn::Iota(d, 0U));
  std::uint64_t carries = 0;
  for (int i = 0; i < count; i += lanes) {
    carries |= BitsOf(hn::Lt(hn::Add(at_p, step), at_p)) << i;
    at_p = hn::Add(at_p, stride);
  }
  return carries;
}

// S^ after `steps` pixels, fewer than 2^16.
HWY_INLINE VS ValuesAt(const PlaneRun& plane, VU steps) {
  const Unsigned d;
  const Signed ds;
  // The whole part of steps * slope, whose halves of 16 bits are multiplied one by one.
  const VU low = hn::ShiftRight<16>(hn::Mul(steps, hn::Set(d, plane.slope & 0xFFFFU)));
  const VU high = hn::Mul(steps, hn::Set(d, plane.slope >> 16));
  const VU product = hn::ShiftRight<16>(hn::Add(high, low));
  const VU whole =
      hn::Add(hn::Set(d, static_cast<std::uint32_t>(plane.whole)),
              hn::Mul(steps, hn::Set(d, static_cast<std::uint32_t>(plane.slope_whole))));
  const auto carries = hn::Lt(FractionsAt(plane, steps), hn::Set(d, plane.fraction));
  const VU carry = hn::IfThenElse(carries, hn::Set(d, 1U), hn::Zero(d));
  return hn::BitCast(ds, hn::Add(hn::Add(whole, product), carry));
}

// The first disparity that is nearer to `above` than to `below`, within the range.
HWY_INLINE VS FirstNearer(VS below, VS above, VS disparities) {
  const Signed d;
  const VS nearer = hn::Add(hn::ShiftRight<1>(hn::Add(below, above)), hn::Set(d, 1));
  return hn::Min(hn::Max(nearer, hn::Zero(d)), disparities);
}

// The Voronoi cell of one plane at each of some pixels; empty where a plane before it stands for
// it.
HWY_INLINE void FindCells(const PlaneRun* planes, int plane_count, VU steps, VS plane,
                          int disparities, VS* begin, VS* end) {
  const Signed d;
  HWY_ALIGN std::int32_t values[PlaneSet::kMaxPlanes * hn::MaxLanes(Signed())];
  VS own = hn::Zero(d);
  for (int k = 0; k < plane_count; ++k) {
    const VS value = ValuesAt(planes[k], steps);
    hn::Store(value, d, values + static_cast<std::size_t>(k) * hn::MaxLanes(d));
    own = hn::IfThenElse(hn::Eq(plane, hn::Set(d, k)), value, own);
  }
  VS below = hn::Set(d, -kFar);
  VS above = hn::Set(d, kFar);
  VS has_none = hn::Zero(d);
  for (int k = 0; k < plane_count; ++k) {
    const VS value = hn::Load(d, values + static_cast<std::size_t>(k) * hn::MaxLanes(d));
    below = hn::IfThenElse(hn::Lt(value, own), hn::Max(below, value), below);
    above = hn::IfThenElse(hn::Gt(value, own), hn::Min(above, value), above);
    const auto stands_for_it = hn::And(hn::Eq(value, own), hn::Gt(plane, hn::Set(d, k)));
    has_none = hn::Or(has_none, hn::VecFromMask(d, stands_for_it));
  }
  const VS all = hn::Set(d, disparities);
  *begin = FirstNearer(below, own, all);
  *end = hn::IfThenElse(hn::Ne(has_none, hn::Zero(d)), *begin, FirstNearer(own, above, all));
}

// Fills `begin` and `end` of the cells that are listed.
HWY_INLINE void FindAllCells(const PlaneRun* planes, int plane_count, int disparities,
                             PlaneMoves* moves) {
  const Signed d;
  for (int i = 0; i < moves->cells; i += static_cast<int>(hn::Lanes(d))) {
    const VU steps = hn::BitCast(Unsigned(), hn::LoadU(d, moves->pixel.data() + i));
    VS begin;
    VS end;
    FindCells(planes, plane_count, steps, hn::LoadU(d, moves->plane.data() + i), disparities,
              &begin, &end);
    hn::StoreU(begin, d, moves->begin.data() + i);
    hn::StoreU(end, d, moves->end.data() + i);
  }
}

// All bits if `is_true`, else none.
HWY_INLINE std::uint64_t AllBits(bool is_true) { return is_true ? ~std::uint64_t{0} : 0; }

// Where the jumps of two planes differ.
HWY_INLINE std::uint64_t DifferenceOf(const PlaneRun& a, std::uint64_t carries_a, const PlaneRun& b,
                                      std::uint64_t carries_b) {
  return (carries_a & carries_b & AllBits(a.jump_with_carry != b.jump_with_carry)) |
         (carries_a & ~carries_b & AllBits(a.jump_with_carry != b.jump)) |
         (~carries_a & carries_b & AllBits(a.jump != b.jump_with_carry)) |
         (~carries_a & ~carries_b & AllBits(a.jump != b.jump));
}

void FollowRuns(const PlaneRun* planes, int plane_count, int count, int disparities,
                PlaneMoves* moves) {
  const std::uint64_t pixels = ~std::uint64_t{0} >> (kMaxPlaneRun - count);
  std::uint64_t jumps[PlaneSet::kMaxPlanes];  // of each plane, where it has one
  std::uint64_t any = 0;
  std::uint64_t more = 0;
  std::uint64_t differ = 0;
  std::uint64_t first_carries = 0;
  for (int k = 0; k < plane_count; ++k) {
    const PlaneRun& plane = planes[k];
    const std::uint64_t carries = CarriesOf(plane, count);
    if (k == 0) first_carries = carries;
    jumps[k] = pixels & ((carries & AllBits(plane.jump_with_carry != 0)) |
                         (~carries & AllBits(plane.jump != 0)));
    more |= any & jumps[k];
    any |= jumps[k];
    differ |= DifferenceOf(planes[0], first_carries, plane, carries);
  }
  moves->alike = any & ~differ;
  moves->several = differ & more;
  moves->cells = 0;
  for (int k = 0; k < plane_count; ++k) {
    for (std::uint64_t alone = jumps[k] & differ & ~more; alone != 0; alone &= alone - 1) {
      const auto cell = static_cast<std::size_t>(moves->cells++);
      moves->pixel[cell] = static_cast<int>(hwy::Num0BitsBelowLS1Bit_Nonzero64(alone));
      moves->plane[cell] = k;
    }
  }
  FindAllCells(planes, plane_count, disparities, moves);
}

}  // namespace HWY_NAMESPACE
}  // namespace stereo_sgmp
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace stereo_sgmp {

HWY_EXPORT(FollowRuns);

void FollowPlaneRuns(const PlaneRun* planes, int plane_count, int count, int disparities,
                     PlaneMoves* moves) {
  HWY_DYNAMIC_DISPATCH(FollowRuns)(planes, plane_count, count, disparities, moves);
}

}  // namespace stereo_sgmp
#endif  // HWY_ONCE
