// The smoothness term V_S of SGM-P: the predecessor's path costs as the transition to the next
// pixel sees them, moved by the jumps of the orientation prior.
#if defined(STEREO_SGMP_AGGREGATION_JUMP_KERNEL_INL_H_) == defined(HWY_TARGET_TOGGLE)
#ifdef STEREO_SGMP_AGGREGATION_JUMP_KERNEL_INL_H_
#undef STEREO_SGMP_AGGREGATION_JUMP_KERNEL_INL_H_
#else
#define STEREO_SGMP_AGGREGATION_JUMP_KERNEL_INL_H_
#endif

#include <hwy/highway.h>

#include <algorithm>
#include <cstddef>
#include <cstdint>

#include "aggregation/path_state.h"
#include "prior/orientation_prior.h"

HWY_BEFORE_NAMESPACE();
namespace stereo_sgmp {
namespace HWY_NAMESPACE {
namespace hn = hwy::HWY_NAMESPACE;

// moved[t] = min(moved[t], costs[t - jump]) for the predecessor's disparities [begin, end). A
// moved disparity counts from -1 to D, since it may still be one step (P1) from a valid one.
HWY_INLINE void MoveSegment(const JumpSegment& segment, const std::uint16_t* costs, int disparities,
                            std::uint16_t* moved) {
  const hn::ScalableTag<std::uint16_t> d;
  const int lanes = static_cast<int>(hn::Lanes(d));
  const int begin = std::max(segment.begin + segment.jump, -1);
  const int end = std::min(segment.end + segment.jump, disparities + 1);
  const auto unreachable = hn::Set(d, PathSlot::kUnreachable);
  for (int t = begin; t < end; t += lanes) {
    const auto inside = hn::FirstN(d, static_cast<std::size_t>(end - t));
    const auto cost = hn::IfThenElse(inside, hn::LoadU(d, costs + t - segment.jump), unreachable);
    hn::StoreU(hn::Min(cost, hn::LoadU(d, moved + t)), d, moved + t);
  }
}

// What is left without the jump: L(p, t) + slack where staying is allowed, else nothing.
HWY_INLINE void StartMoved(const std::uint16_t* costs, int disparities, int slack,
                           std::uint16_t* moved) {
  const hn::ScalableTag<std::uint16_t> d;
  const int lanes = static_cast<int>(hn::Lanes(d));
  const auto unreachable = hn::Set(d, PathSlot::kUnreachable);
  const auto price = hn::Set(d, static_cast<std::uint16_t>(std::max(slack, 0)));
  for (int t = -PathSlot::kPad; t <= disparities; t += lanes) {
    const auto stay = hn::Min(hn::Add(hn::Load(d, costs + t), price), unreachable);
    hn::Store(slack >= 0 ? stay : unreachable, d, moved + t);
  }
}

// The costs e(t) = min over d with d + j(d) = t of L(p, d), and L(p, t) + slack if slack >= 0.
// Points into `costs` where that will do, else into the slot `scratch`.
HWY_INLINE const std::uint16_t* MovePredecessor(const JumpRow& row, std::size_t entry,
                                                const std::uint16_t* costs, int disparities,
                                                int slack, std::uint16_t* scratch) {
  const int jump = row.jump[entry];
  if (jump == 0) return costs;
  const bool varies = jump == JumpRow::kVaries;
  if (!varies && slack < 0 && std::abs(jump) < PathSlot::kPad) return costs - jump;

  std::uint16_t* moved = scratch + PathSlot::kPad;
  StartMoved(costs, disparities, slack, moved);
  if (varies) {
    const JumpSegment* segment = row.segments.data() + row.first_segment[entry];
    for (int i = 0; i < row.segment_count[entry]; ++i) {
      MoveSegment(segment[i], costs, disparities, moved);
    }
  } else {
    MoveSegment({0, disparities, jump}, costs, disparities, moved);
  }
  return moved;
}

}  // namespace HWY_NAMESPACE
}  // namespace stereo_sgmp
HWY_AFTER_NAMESPACE();

#endif  // per-target include guard
