// One pixel's step of several paths: path costs from the messages of the predecessors (Eq. 3),
// and the messages to the next pixels.
#if defined(STEREO_SGMP_AGGREGATION_MESSAGE_KERNEL_INL_H_) == defined(HWY_TARGET_TOGGLE)
#ifdef STEREO_SGMP_AGGREGATION_MESSAGE_KERNEL_INL_H_
#undef STEREO_SGMP_AGGREGATION_MESSAGE_KERNEL_INL_H_
#else
#define STEREO_SGMP_AGGREGATION_MESSAGE_KERNEL_INL_H_
#endif

#include <hwy/highway.h>

#include <cstdint>

#include "aggregation/lanes-inl.h"
#include "aggregation/path_state.h"

HWY_BEFORE_NAMESPACE();
namespace stereo_sgmp {
namespace HWY_NAMESPACE {
namespace hn = hwy::HWY_NAMESPACE;

// Number of vectors of a pixel that is not known at compile time.
inline constexpr int kAnyVectors = 0;

// Disparities of a pixel as vectors. With `kVectors` known, loops over it unroll, and what a loop
// leaves for the next stays in registers. Those that are `kFull` have no lanes beyond the last
// disparity.
template <class T, int kVectors, bool kFull>
struct PixelShape {
  static constexpr int kMaxDisparities = 2048;
  static constexpr int kVectorCount = kVectors;
  static constexpr int kLaneCount = kVectors * kLanes<T>;  // 0 if it is not known
  static constexpr bool kIsFull = kFull;
  static constexpr int kMost =
      kVectors != kAnyVectors ? kVectors : (kMaxDisparities + kLanes<T> - 1) / kLanes<T>;

  int vectors = 0;
  int all_vectors = 0;  // with those of disparities that the pixel does not reach
  Lanes<T> tail;        // of the last vector: all bits of the lanes beyond the last disparity

  PixelShape(int disparities, int all_disparities)
      : vectors(VectorsOf(disparities)),
        all_vectors(VectorsOf(all_disparities)),
        tail(TailBits<T>(disparities - (vectors - 1) * kLanes<T>)) {}

  static constexpr int VectorsOf(int disparities) {
    return (disparities + kLanes<T> - 1) / kLanes<T>;
  }

  int Count() const { return kVectors != kAnyVectors ? kVectors : vectors; }
  int LaneCount() const { return Count() * kLanes<T>; }

  // The last vector with all bits set in the lanes beyond the last disparity.
  HWY_INLINE Lanes<T> WithTail(Lanes<T> last) const {
    if constexpr (kFull) {
      return last;
    } else {
      return hn::Or(last, tail);
    }
  }
};

// One path at one pixel: the message it receives, the penalty of a large step from there, and where
// the message it sends goes.
template <class T>
struct PathStepState {
  const T* received;
  const T* p2;
  T* sent;
};

template <class T>
HWY_INLINE Lanes<T> LoadCosts(const std::uint8_t* cost) {
  const Tag<T> d;
  if constexpr (sizeof(T) == 1) {
    return hn::Load(d, cost);
  } else {
    const hn::Rebind<std::uint8_t, Tag<T>> narrow;
    return hn::PromoteTo(d, hn::Load(narrow, cost));
  }
}

// Sends the message of the path costs `l`, of which the least is `smallest`. That is taken off
// last: the steps between disparities need not wait for it.
template <class T, class Shape>
HWY_INLINE void Send(const Shape& shape, const Lanes<T>* l, Lanes<T> smallest, Lanes<T> p1,
                     T* sent) {
  const Tag<T> d;
  const Lanes<T> unreachable = hn::Set(d, PathSlot<T>::kUnreachable);
  const int last = shape.Count() - 1;
  for (int v = 0; v <= last; ++v) {
    const Lanes<T> above = FromAbove<T>(l[v], v < last ? l[v + 1] : unreachable);
    const Lanes<T> below = FromBelow<T>(v > 0 ? l[v - 1] : unreachable, l[v]);
    const Lanes<T> step = hn::SaturatedAdd(hn::Min(below, above), p1);
    const Lanes<T> message = hn::Sub(hn::Min(l[v], step), smallest);
    hn::Store(v == last ? shape.WithTail(message) : message, d, sent + v * kLanes<T>);
  }
}

// Advances a path to one pixel. `l` receives what its costs exceed their least by, and beyond the
// last disparity at least as much. Returns the least, min_d L_r.
template <class T, class Shape>
HWY_INLINE int AdvancePath(const Shape& shape, const PathStepState<T>& path,
                           const std::uint8_t* cost, Lanes<T> p1, Lanes<T>* l) {
  const Tag<T> d;
  const int last = shape.Count() - 1;
  const Lanes<T> p2 = hn::Set(d, *path.p2);
  Lanes<T> least = hn::Set(d, PathSlot<T>::kUnreachable);
  for (int v = 0; v <= last; ++v) {
    const Lanes<T> received = hn::LoadU(d, path.received + v * kLanes<T>);
    l[v] = hn::Add(LoadCosts<T>(cost + v * kLanes<T>), hn::Min(received, p2));
    if (v == last) l[v] = shape.WithTail(l[v]);
    least = v == 0 ? l[v] : hn::Min(least, l[v]);
  }
  const Lanes<T> smallest = SmallestOfLanes(d, least);
  Send<T>(shape, l, smallest, p1, path.sent);
  for (int v = 0; v <= last; ++v) l[v] = hn::Sub(l[v], smallest);
  return hn::GetLane(smallest);
}

// Advances kPaths paths to one pixel, whose steps `cursor` has. `sums` receives the sum of what
// their costs exceed their least by (AddExcess), vector by vector. Returns the sum of min_d L_r.
template <class T, int kPaths, class Shape, class Cursor>
HWY_INLINE int AdvancePaths(const Shape& shape, const Cursor& cursor, const std::uint8_t* cost,
                            Lanes<T> p1, Lanes<T>* sums) {
  static_assert(kPaths % 2 == 0, "paths are summed in pairs");
  const Tag<T> d;
  for (int v = 0; v < shape.Count(); ++v) sums[v] = hn::Zero(d);
  Lanes<T> one[Shape::kMost];
  Lanes<T> other[Shape::kMost];
  int minimum_sum = 0;
  ForEach<kPaths / 2>(kPaths / 2, [&](int pair) STEREO_SGMP_INLINE_ATTR {
    minimum_sum += AdvancePath<T>(shape, cursor.Step(2 * pair), cost, p1, one);
    minimum_sum += AdvancePath<T>(shape, cursor.Step(2 * pair + 1), cost, p1, other);
    for (int v = 0; v < shape.Count(); ++v) sums[v] = AddExcess<T>(sums[v], one[v], other[v]);
  });
  return minimum_sum;
}

// Completes the messages by the disparities that the pixel does not reach: its neighbour may.
template <class T, int kPaths, class Shape, class Cursor>
HWY_INLINE void SendUnreached(const Shape& shape, const Cursor& cursor) {
  const Tag<T> d;
  ForEach<kPaths>(kPaths, [&](int path) STEREO_SGMP_INLINE_ATTR {
    for (int v = shape.Count(); v < shape.all_vectors; ++v) {
      hn::Store(hn::Set(d, PathSlot<T>::kUnreachable), d, cursor.Sent(path) + v * kLanes<T>);
    }
  });
}

}  // namespace HWY_NAMESPACE
}  // namespace stereo_sgmp
HWY_AFTER_NAMESPACE();

#endif  // per-target include guard
