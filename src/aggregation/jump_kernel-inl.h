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

#include "aggregation/lane_masks.h"
#include "aggregation/lanes-inl.h"
#include "aggregation/path_state.h"
#include "prior/orientation_prior.h"

HWY_BEFORE_NAMESPACE();
namespace stereo_sgmp {
namespace HWY_NAMESPACE {
namespace hn = hwy::HWY_NAMESPACE;

// A message, which moves where it stands, since one pixel alone receives it.
template <class T>
struct Journey {
  T* message;
  int disparities;      // of the pixel that it arrives at
  int all_disparities;  // of the volume: the pixel that it comes from may have more or fewer
  T price_of_staying;   // what it costs not to follow the jump
};

// Without a jump the message arrives where it is, for the price of the slack.
template <class T>
HWY_INLINE void Stay(const Journey<T>& journey, T* moved) {
  const Tag<T> d;
  const Lanes<T> slack = hn::Set(d, journey.price_of_staying);
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

// Of the lanes of the vector at disparity index t, those of the indices [begin, end).
template <class T>
HWY_INLINE hn::Mask<Tag<T>> LanesOf(int begin, int end, int t) {
  const Tag<T> d;
#if HWY_TARGET <= HWY_AVX3
  const auto below = [d, t](int index) HWY_ATTR {
    return hn::FirstN(d, static_cast<std::size_t>(std::clamp(index - t, 0, kLanes<T>)));
  };
  return hn::AndNot(below(begin), below(end));
#else
  const auto from = [d, t](int index)
                        HWY_ATTR { return hn::LoadU(d, RangeMasks<T>::From(index) + t); };
  return hn::MaskFromVec(hn::AndNot(from(end), from(begin)));
#endif
}

// Moves the disparities of several segments, or by more than PathSlot::kPad. `scratch` has room for
// a message.
template <class T>
HWY_NOINLINE void MoveSegments(const JumpRow& row, std::size_t entry, Journey<T> journey,
                               T* scratch) {
  const Tag<T> d;
  Stay(journey, scratch);
  if (row.jump[entry] == JumpRow::kVaries) {
    const JumpSegment* const segments = row.segments.data() + row.first_segment[entry];
    for (int i = 0; i < row.segment_count[entry]; ++i) Arrive(segments[i], journey, scratch);
  } else {
    const int begin = row.begin[entry];
    const int end = std::min<int>(row.end[entry], journey.all_disparities);
    Arrive({0, begin, 0}, journey, scratch);
    Arrive({begin, end, row.jump[entry]}, journey, scratch);
    Arrive({end, journey.all_disparities, 0}, journey, scratch);
  }
  for (int t = 0; t < journey.disparities; t += kLanes<T>) {
    hn::Store(hn::Load(d, scratch + t), d, journey.message + t);
  }
}

// Calls move(t) for the vectors of the disparities [begin, end), against the direction of the jump,
// so that none is read after it has been written.
template <class T, class Move>
HWY_INLINE void ForVectors(int begin, int end, int jump, const Move& move) {
  const int first = begin & -kLanes<T>;
  const int last = (end - 1) & -kLanes<T>;
  if (jump > 0) {
    for (int t = last; t >= first; t -= kLanes<T>) move(t);
  } else {
    for (int t = first; t <= last; t += kLanes<T>) move(t);
  }
}

// Moves the disparities [begin, end) by up to PathSlot::kPad.
template <class T>
HWY_INLINE void MoveCell(int begin, int end, int jump, const Journey<T>& journey) {
  const Tag<T> d;
  const Lanes<T> price = hn::Set(d, journey.price_of_staying);
  const Lanes<T> unreachable = hn::Set(d, PathSlot<T>::kUnreachable);
  const auto move = [&](int t) STEREO_SGMP_INLINE_ATTR {
    T* const place = journey.message + t;
    const auto leaves = LanesOf<T>(begin, end, t);
    const auto comes = LanesOf<T>(begin + jump, end + jump, t);
    const Lanes<T> here = hn::Load(d, place);
    const Lanes<T> stays = hn::IfThenElse(leaves, hn::SaturatedAdd(here, price), here);
    const Lanes<T> arrives = hn::IfThenElse(comes, hn::LoadU(d, place - jump), unreachable);
    hn::Store(hn::Min(stays, arrives), d, place);
  };
  ForVectors<T>(std::max(0, std::min(begin, begin + jump)),
                std::min(journey.disparities, std::max(end, end + jump)), jump, move);
}

// As MoveMessage; the jump is neither 1 nor -1.
template <class T>
HWY_NOINLINE void MoveFar(const JumpRow& row, std::size_t entry, const Journey<T>& journey,
                          T* scratch) {
  const int jump = row.jump[entry];
  if (jump < -PathSlot<T>::kPad || jump > PathSlot<T>::kPad) {
    return MoveSegments(row, entry, journey, scratch);
  }
  MoveCell(row.begin[entry], std::min<int>(row.end[entry], journey.all_disparities), jump, journey);
}

// Moves the disparities [begin, end) up or down by one. What arrives is shifted in registers: read
// across vectors that have just been stored, it would have to wait for them.
template <bool kUp, class T, class Shape>
HWY_INLINE void MoveByOne(const Shape& shape, int begin, int end, Lanes<T> price, T* message) {
  const Tag<T> d;
  const Lanes<T> unreachable = hn::Set(d, PathSlot<T>::kUnreachable);
  const T* const from_begin = RangeMasks<T>::From(begin);
  const T* const from_end = RangeMasks<T>::From(end);
  struct Part {
    Lanes<T> stays;
    Lanes<T> leaves;
  };
  const auto part = [&](int v) STEREO_SGMP_INLINE_ATTR {
    const int t = v * kLanes<T>;
    const Lanes<T> there = hn::Load(d, message + t);
    const Lanes<T> moves = hn::AndNot(hn::LoadU(d, from_end + t), hn::LoadU(d, from_begin + t));
    return Part{hn::SaturatedAdd(there, hn::And(moves, price)), hn::Or(there, hn::Not(moves))};
  };
  const int last = shape.Count() - 1;
  // Behind the last vector may stand disparities that only the predecessor reaches.
  const bool is_all = shape.Count() == shape.all_vectors;
  Part here = part(kUp ? last : 0);
  ForEach<Shape::kVectorCount>(shape.Count(), [&](int i) STEREO_SGMP_INLINE_ATTR {
    const int v = kUp ? last - i : i;
    const bool has_next = kUp ? v > 0 : v < last || !is_all;
    const Part next = has_next ? part(kUp ? v - 1 : v + 1) : Part{unreachable, unreachable};
    const Lanes<T> arrives =
        kUp ? FromBelow<T>(next.leaves, here.leaves) : FromAbove<T>(here.leaves, next.leaves);
    hn::Store(hn::Min(here.stays, arrives), d, message + v * kLanes<T>);
    here = next;
  });
}

// Leaves of a message the least of M_r(p, d) over the d with d + j_p(d) = t, and of M_r(p, t) + the
// price of staying, for every t. `scratch` has room for a message.
template <class T, class Shape>
HWY_INLINE void MoveMessage(const Shape& shape, const JumpRow& row, std::size_t entry,
                            const Journey<T>& journey, T* scratch) {
  const int jump = row.jump[entry];
  if (HWY_UNLIKELY(jump != 1 && jump != -1)) return MoveFar(row, entry, journey, scratch);
  const int begin = row.begin[entry];
  const int end = std::min<int>(row.end[entry], journey.all_disparities);
  const Lanes<T> price = hn::Set(Tag<T>(), journey.price_of_staying);
  if (jump > 0) {
    MoveByOne<true>(shape, begin, end, price, journey.message);
  } else {
    MoveByOne<false>(shape, begin, end, price, journey.message);
  }
}

}  // namespace HWY_NAMESPACE
}  // namespace stereo_sgmp
HWY_AFTER_NAMESPACE();

#endif  // per-target include guard
