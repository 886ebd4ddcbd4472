// The smoothness term V_S of SGM-P: the predecessor's message as the next pixel receives it, moved
// by the jumps of the orientation prior.
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
#include <cstdlib>

#include "aggregation/lane_masks.h"
#include "aggregation/lanes-inl.h"
#include "aggregation/path_state.h"
#include "prior/orientation_prior.h"

HWY_BEFORE_NAMESPACE();
namespace stereo_sgmp {
namespace HWY_NAMESPACE {
namespace hn = hwy::HWY_NAMESPACE;

// A message on its way, and what it costs not to follow the jump; less than 0: no way around it.
template <class T>
struct Journey {
  const T* message;
  int disparities;
  int slack;
};

// What arrives at the disparities [t, t + lanes) of all that moves by one jump: the message of
// t - jump where that is in [begin, end), kUnreachable elsewhere.
template <class T>
HWY_INLINE Lanes<T> ArrivalsOf(const JumpSegment& segment, const Journey<T>& journey, int t) {
  const Tag<T> d;
  const int first = std::max(segment.begin + segment.jump, 0) - t;
  const int end = std::min(segment.end + segment.jump, journey.disparities) - t;
  if (end <= 0 || first >= kLanes<T>) return hn::Set(d, PathSlot<T>::kUnreachable);
  Lanes<T> arrived = hn::LoadU(d, journey.message + t - segment.jump);
  if (first > 0) arrived = hn::Or(arrived, hn::LoadU(d, LaneMasks<T>::Below(first)));
  if (end < kLanes<T>) arrived = hn::Or(arrived, hn::LoadU(d, LaneMasks<T>::From(end)));
  return arrived;
}

// Without a jump the message arrives where it is, for the price of the slack.
template <class T>
HWY_INLINE Lanes<T> Stayed(const Journey<T>& journey, int t) {
  const Tag<T> d;
  if (journey.slack < 0) return hn::Set(d, PathSlot<T>::kUnreachable);
  return hn::SaturatedAdd(hn::Load(d, journey.message + t),
                          hn::Set(d, static_cast<T>(journey.slack)));
}

template <class T>
HWY_INLINE void MoveAll(int jump, const Journey<T>& journey, T* moved) {
  const JumpSegment all{0, journey.disparities, jump};
  for (int t = 0; t < journey.disparities; t += kLanes<T>) {
    hn::Store(hn::Min(Stayed(journey, t), ArrivalsOf(all, journey, t)), Tag<T>(), moved + t);
  }
}

template <class T>
HWY_INLINE void MoveSegments(const JumpSegment* segments, int count, const Journey<T>& journey,
                             T* moved) {
  for (int t = 0; t < journey.disparities; t += kLanes<T>) {
    Lanes<T> arrived = Stayed(journey, t);
    for (int i = 0; i < count; ++i) {
      arrived = hn::Min(arrived, ArrivalsOf(segments[i], journey, t));
    }
    hn::Store(arrived, Tag<T>(), moved + t);
  }
}

// The least of M_r(p, d) over the d with d + j_p(d) = t, and of M_r(p, t) + slack if slack >= 0,
// for every t. Points into the message where that will do, else into the slot `scratch`.
template <class T>
HWY_INLINE const T* MoveMessage(const JumpRow& row, std::size_t entry, const Journey<T>& journey,
                                T* scratch) {
  const int jump = row.jump[entry];
  if (jump == 0) return journey.message;
  const bool varies = jump == JumpRow::kVaries;
  if (!varies && journey.slack < 0 && std::abs(jump) <= PathSlot<T>::kPad) {
    return journey.message - jump;
  }
  T* moved = scratch + PathSlot<T>::kPad;
  if (varies) {
    MoveSegments(row.segments.data() + row.first_segment[entry], row.segment_count[entry], journey,
                 moved);
  } else {
    MoveAll(jump, journey, moved);
  }
  return moved;
}

}  // namespace HWY_NAMESPACE
}  // namespace stereo_sgmp
HWY_AFTER_NAMESPACE();

#endif  // per-target include guard
