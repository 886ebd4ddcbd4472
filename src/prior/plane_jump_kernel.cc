#include "prior/plane_jump_kernel.h"

#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "prior/plane_jump_kernel.cc"
#include <hwy/foreach_target.h>

#include <hwy/highway.h>

#include <cstddef>

#include "prior/plane_sets.h"
#include "prior/plane_vectors-inl.h"

HWY_BEFORE_NAMESPACE();
namespace stereo_sgmp {
namespace HWY_NAMESPACE {
namespace hn = hwy::HWY_NAMESPACE;

// Beyond the rounded disparity of any plane; sums of two such numbers still fit.
inline constexpr std::int32_t kFar = 1 << 30;

// Bit by bit, at which of `count` pixels the fraction carries on each of some steps to q.
template <int kSteps>
HWY_INLINE void FindCarries(const PlaneRun& plane, const PlaneStep* const (&steps)[kSteps],
                            int count, std::uint64_t (&carries)[kSteps]) {
  const Unsigned d;
  const int lanes = static_cast<int>(hn::Lanes(d));
  const VU stride = hn::Set(d, plane.slope * static_cast<std::uint32_t>(lanes));
  VU at_p = FractionsAt(plane, hn::Iota(d, 0U));
  for (std::uint64_t& bits : carries) bits = 0;
  for (int i = 0; i < count; i += lanes) {
    for (int s = 0; s < kSteps; ++s) {
      const VU at_q = hn::Add(at_p, hn::Set(d, steps[s]->fraction));
      carries[s] |= BitsOf(d, hn::Lt(at_q, at_p)) << i;
    }
    at_p = hn::Add(at_p, stride);
  }
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

// Fills `begin` and `end` of the `count` cells that are listed, and
// takes the jumps away from those that are empty.
HWY_INLINE void FindAllCells(const PlaneRuns& runs, int count, PlaneMoves* moves) {
  const Signed d;
  for (int i = 0; i < count; i += static_cast<int>(hn::Lanes(d))) {
    const VU steps = hn::BitCast(Unsigned(), hn::LoadU(d, moves->pixel.data() + i));
    VS begin;
    VS end;
    FindCells(runs.planes, runs.plane_count, steps, hn::LoadU(d, moves->plane.data() + i),
              runs.disparities, &begin, &end);
    hn::StoreU(begin, d, moves->begin.data() + i);
    hn::StoreU(end, d, moves->end.data() + i);
    const VS jump = hn::LoadU(d, moves->jump.data() + i);
    hn::StoreU(hn::IfThenElseZero(hn::Lt(begin, end), jump), d, moves->jump.data() + i);
  }
}

// All bits if `is_true`, else none.
HWY_INLINE std::uint64_t AllBits(bool is_true) { return is_true ? ~std::uint64_t{0} : 0; }

// The jumps of all planes on one step, pixel by pixel as bits.
struct StepBits {
  std::uint64_t carries[PlaneSet::kMaxPlanes];  // of each plane
  std::uint64_t jumps[PlaneSet::kMaxPlanes];    // of each plane, where it has one
  std::uint64_t any;
  std::uint64_t more;  // where more than one plane has one
  std::uint64_t all;   // where all have one

  // `may_be_all`: the pixels where all planes may have one.
  HWY_INLINE void Start(std::uint64_t may_be_all) {
    any = 0;
    more = 0;
    all = may_be_all;
  }

  HWY_INLINE void Add(int k, const PlaneStep& step, std::uint64_t carried, std::uint64_t pixels) {
    carries[k] = carried;
    jumps[k] = pixels & ((carried & AllBits(step.jump_with_carry != 0)) |
                         (~carried & AllBits(step.jump != 0)));
    more |= any & jumps[k];
    any |= jumps[k];
    all &= jumps[k];
  }
};

// Of the pixels where all planes jump, those where they jump by the same.
HWY_INLINE std::uint64_t FindAlike(const PlaneRuns& runs, int step, std::uint64_t all) {
  std::uint64_t alike = 0;
  for (; all != 0; all &= all - 1) {
    const int i = static_cast<int>(hwy::Num0BitsBelowLS1Bit_Nonzero64(all));
    const int first = runs.JumpAt(step, 0, i);
    bool is_alike = true;
    for (int k = 1; k < runs.plane_count; ++k) is_alike &= runs.JumpAt(step, k, i) == first;
    alike |= std::uint64_t{is_alike} << i;
  }
  return alike;
}

// Lists the pixels at which a plane jumps alone. Returns the number of cells listed so far.
HWY_INLINE int ListCells(const PlaneRuns& runs, int step, const StepBits& bits, std::uint64_t alike,
                         int cells, PlaneMoves* moves) {
  for (int m = 0; m < runs.moving_count; ++m) {
    const int k = runs.moving[m];
    const PlaneStep& jumps = runs.StepOf(step, k);
    std::uint64_t alone = bits.jumps[k] & ~(bits.more | alike);
    for (; alone != 0; alone &= alone - 1, ++cells) {
      const auto cell = static_cast<std::size_t>(cells);
      const int pixel = static_cast<int>(hwy::Num0BitsBelowLS1Bit_Nonzero64(alone));
      moves->pixel[cell] = pixel;
      moves->plane[cell] = k;
      moves->jump[cell] = (bits.carries[k] >> pixel & 1) != 0 ? jumps.jump_with_carry : jumps.jump;
    }
  }
  return cells;
}

template <int kSteps>
HWY_INLINE void FollowSteps(const PlaneRuns& runs, PlaneMoves* moves) {
  StepBits bits[kSteps];
  for (int s = 0; s < kSteps; ++s) {
    bits[s].Start(runs.moving_count == runs.plane_count ? runs.pixels[s] : 0);
  }
  for (int m = 0; m < runs.moving_count; ++m) {
    const int k = runs.moving[m];
    const PlaneStep* steps[kSteps];
    for (int s = 0; s < kSteps; ++s) steps[s] = &runs.StepOf(s, k);
    std::uint64_t carries[kSteps];
    FindCarries(runs.planes[k], steps, runs.count, carries);
    for (int s = 0; s < kSteps; ++s) bits[s].Add(k, *steps[s], carries[s], runs.pixels[s]);
  }
  int cells = 0;
  for (int s = 0; s < kSteps; ++s) {
    const auto step = static_cast<std::size_t>(s);
    const std::uint64_t alike = FindAlike(runs, s, bits[s].all);
    cells = ListCells(runs, s, bits[s], alike, cells, moves);
    moves->alike[step] = alike;
    moves->several[step] = bits[s].more & ~alike;
    moves->cells_end[step] = cells;
  }
  FindAllCells(runs, cells, moves);
}

void FollowRuns(const PlaneRuns& runs, PlaneMoves* moves) {
  static_assert(kMaxPlaneSteps == 3, "one case for each number of steps");
  switch (runs.step_count) {
    case 1:
      return FollowSteps<1>(runs, moves);
    case 2:
      return FollowSteps<2>(runs, moves);
    default:
      return FollowSteps<3>(runs, moves);
  }
}

}  // namespace HWY_NAMESPACE
}  // namespace stereo_sgmp
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace stereo_sgmp {

HWY_EXPORT(FollowRuns);

void FollowPlaneRuns(const PlaneRuns& runs, PlaneMoves* moves) {
  HWY_DYNAMIC_DISPATCH(FollowRuns)(runs, moves);
}

}  // namespace stereo_sgmp
#endif  // HWY_ONCE
