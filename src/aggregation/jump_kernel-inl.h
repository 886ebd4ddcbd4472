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
  int disparities;      // of the pixel that it arrives at
  int all_disparities;  // of the volume: the pixel that it comes from may have more or fewer
  int slack;
};

// The slack, or a price that nothing can pay where there is no way around the jump.
template <class T>
HWY_INLINE T PriceOfStaying(const Journey<T>& journey) {
  return journey.slack < 0 ? PathSlot<T>::kUnreachable : static_cast<T>(journey.slack);
}

// Without a jump the message arrives where it is, for the price of the slack.
template <class T>
HWY_INLINE void Stay(const Journey<T>& journey, T* moved) {
  const Tag<T> d;
  const Lanes<T> slack = hn::Set(d, PriceOfStaying(journey));
  for (int t = 0; t < journey.disparities; t += kLanes<T>) {
    hn::Store(hn::SaturatedAdd(hn::Load(d, journey.message + t), slack), d, moved + t);
  }
}

// The message of the disparities of a segment arrives where their jump leads, if that costs less.
template <class T>
HWY_INLINE void Arrive(const JumpSegment& segment, const Journey<T>& journey, T* moved) {
  const Tag<T> d;
  const int first = std::max(segment.begin + segment.jump, 0);
  const int end = std::min(segment.end + segment.jump, journey.disparities);
  if (first >= end) return;
  const T* from_first = RangeMasks<T>::From(first);
  const T* from_end = RangeMasks<T>::From(end);
  for (int t = first & -kLanes<T>; t < end; t += kLanes<T>) {
    const Lanes<T> comes = hn::AndNot(hn::LoadU(d, from_end + t), hn::LoadU(d, from_first + t));
    const Lanes<T> arrived = hn::LoadU(d, journey.message + t - segment.jump);
    const Lanes<T> there = hn::Load(d, moved + t);
    hn::Store(hn::Min(there, hn::Or(arrived, hn::Not(comes))), d, moved + t);
  }
}

// What arrives where all disparities move by up to PathSlot::kPad.
template <class T>
HWY_INLINE void MoveAll(int jump, const Journey<T>& journey, T* moved) {
  const Tag<T> d;
  const Lanes<T> price = hn::Set(d, PriceOfStaying(journey));
  for (int t = 0; t < journey.disparities; t += kLanes<T>) {
    const Lanes<T> stays = hn::SaturatedAdd(hn::Load(d, journey.message + t), price);
    hn::Store(hn::Min(stays, hn::LoadU(d, journey.message + t - jump)), d, moved + t);
  }
}

// What arrives where one cell moves by up to PathSlot::kPad, in one pass over the message.
template <class T>
HWY_INLINE void MoveCell(const JumpSegment& cell, const Journey<T>& journey, T* moved) {
  const Tag<T> d;
  const Lanes<T> price = hn::Set(d, PriceOfStaying(journey));
  const T* from_begin = RangeMasks<T>::From(cell.begin);
  const T* from_end = RangeMasks<T>::From(cell.end);
  for (int t = 0; t < journey.disparities; t += kLanes<T>) {
    const Lanes<T> leaves = hn::AndNot(hn::LoadU(d, from_end + t), hn::LoadU(d, from_begin + t));
    const Lanes<T> comes = hn::AndNot(hn::LoadU(d, from_end + t - cell.jump),
                                      hn::LoadU(d, from_begin + t - cell.jump));
    const Lanes<T> here = hn::Load(d, journey.message + t);
    const Lanes<T> from_afar = hn::LoadU(d, journey.message + t - cell.jump);
    const Lanes<T> stays = hn::SaturatedAdd(here, hn::And(leaves, price));
    hn::Store(hn::Min(stays, hn::Or(from_afar, hn::Not(comes))), d, moved + t);
  }
}

// The same for any number of segments and any distance.
template <class T>
HWY_INLINE void MoveSegments(const JumpSegment* segments, int count, const Journey<T>& journey,
                             T* moved) {
  Stay(journey, moved);
  for (int i = 0; i < count; ++i) Arrive(segments[i], journey, moved);
}

// The least of M_r(p, d) over the d with d + j_p(d) = t, and of M_r(p, t) + slack if slack >= 0,
// for every t. Points into the message where that will do, else into the slot `scratch`.
template <class T>
HWY_INLINE const T* MoveMessage(const JumpRow& row, std::size_t entry, const Journey<T>& journey,
                                T* scratch) {
  const int jump = row.jump[entry];
  if (jump == 0) return journey.message;
  T* moved = scratch + PathSlot<T>::kPad;
  if (jump == JumpRow::kVaries) {
    MoveSegments(row.segments.data() + row.first_segment[entry], row.segment_count[entry], journey,
                 moved);
    return moved;
  }
  const int begin = row.begin[entry];
  const int end = std::min<int>(row.end[entry], journey.all_disparities);
  if (std::abs(jump) > PathSlot<T>::kPad) {
    const JumpSegment segments[] = {
        {0, begin, 0}, {begin, end, jump}, {end, journey.all_disparities, 0}};
    MoveSegments(segments, 3, journey, moved);
    return moved;
  }
  const bool moves_all = begin == 0 && end == journey.all_disparities;
  if (moves_all && journey.slack < 0) return journey.message - jump;
  if (moves_all) {
    MoveAll(jump, journey, moved);
  } else {
    MoveCell({begin, end, jump}, journey, moved);
  }
  return moved;
}

}  // namespace HWY_NAMESPACE
}  // namespace stereo_sgmp
HWY_AFTER_NAMESPACE();

#endif  // per-target include guard
