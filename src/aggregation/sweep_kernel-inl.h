// The innermost loops of the aggregation, for every SIMD target. Each file that includes this has
// some of their shapes compiled.
#if defined(STEREO_SGMP_AGGREGATION_SWEEP_KERNEL_INL_H_) == defined(HWY_TARGET_TOGGLE)
#ifdef STEREO_SGMP_AGGREGATION_SWEEP_KERNEL_INL_H_
#undef STEREO_SGMP_AGGREGATION_SWEEP_KERNEL_INL_H_
#else
#define STEREO_SGMP_AGGREGATION_SWEEP_KERNEL_INL_H_
#endif

#include <hwy/cache_control.h>
#include <hwy/highway.h>

#include <cstddef>
#include <cstdint>

#include "aggregation/lanes-inl.h"
#include "aggregation/message_kernel-inl.h"
#include "aggregation/right_window-inl.h"
#include "aggregation/step_kernel-inl.h"
#include "aggregation/stretch_sums-inl.h"
#include "aggregation/winner_kernel-inl.h"

HWY_BEFORE_NAMESPACE();
namespace stereo_sgmp {
namespace HWY_NAMESPACE {
namespace hn = hwy::HWY_NAMESPACE;

// What is read once, in chunks of a stretch, is more than the hardware fetches ahead alone.
template <class Shape, class T>
HWY_INLINE void PrefetchPixel(const Shape& shape, const T* pixel) {
  constexpr int kLine = 64 / sizeof(T);  // of the cache
  constexpr int kLines = (Shape::kLaneCount + kLine - 1) / kLine;
  ForEach<kLines>((shape.LaneCount() + kLine - 1) / kLine,
                  [&](int i) STEREO_SGMP_INLINE_ATTR { hwy::Prefetch(pixel + i * kLine); });
}

// Of a pixel from the first one of its stretch, in pixels of the image.
using Offset = std::ptrdiff_t;

// Moves along a stretch; calls `finish(offset, half, minima)` for each pixel, with the sum of its
// path costs and that of their minima, min_d L_r.
template <class T, int kPaths, class Shape, class Finish>
HWY_INLINE void ForEachPixel(const SweepStretch<T>& s, const Shape& shape, const Finish& finish) {
  constexpr int kAhead = 8;
  const Lanes<T> p1 = hn::Set(Tag<T>(), s.p1);
  if (s.moves != nullptr && s.has_above && !s.above_has_moved) MoveFromAbove(s, shape);
  StepCursor<T, Shape> cursor(s, shape);
  // Kept here for the same reason as what StepCursor keeps.
  const int u_end = s.u_end;
  const Offset x_step = s.x_step;
  const bool has_stored_costs = s.has_stored_costs;
  const std::ptrdiff_t cost_step = x_step * s.stride;
  const std::uint8_t* cost = s.cost;
  Offset offset = 0;
  for (int u = s.u_begin; u < u_end; ++u) {
    if (has_stored_costs) PrefetchPixel(shape, cost + kAhead * cost_step);
    cursor.Enter(u, offset);
    Lanes<T> half[Shape::kMost];
    const int minima = AdvancePaths<T, kPaths>(shape, cursor, cost, p1, half);
    if (HWY_UNLIKELY(shape.Count() < shape.all_vectors)) SendUnreached<T, kPaths>(shape, cursor);
    cursor.Leave();
    finish(offset, half, minima);
    cost += cost_step;
    offset += x_step;
  }
  cursor.Finish();
}

template <class T, int kPaths, class Shape>
void First(const SweepStretch<T>& s) {
  const Shape shape(s.disparities, s.all_disparities);
  T* const first = s.sum;
  const std::ptrdiff_t stride = s.stride;
  std::uint16_t* const minimum_sum = s.minimum_sum;
  const auto store = [&](Offset offset, const Lanes<T>* half, int minima) STEREO_SGMP_INLINE_ATTR {
    T* sum = first - offset * stride;
    for (int v = 0; v < shape.Count(); ++v) hn::Stream(half[v], Tag<T>(), sum + v * kLanes<T>);
    minimum_sum[offset] = static_cast<std::uint16_t>(minima);
  };
  ForEachPixel<T, kPaths>(s, shape, store);
}

template <class T, int kPaths, class Shape>
void States(const SweepStretch<T>& s) {
  const Shape shape(s.disparities, s.all_disparities);
  const auto ignore = [](Offset, const Lanes<T>*, int) STEREO_SGMP_INLINE_ATTR {};
  ForEachPixel<T, kPaths>(s, shape, ignore);
}

// Completes S of the pixels of a stretch.
template <class T, int kPaths, class Shape>
HWY_INLINE void CompleteSums(const SweepStretch<T>& s, const Shape& shape,
                             StretchSums<T, Shape>* sums) {
  constexpr int kAhead = 4;
  const T* const ahead = StoredSum(s, kAhead * s.x_step);
  const std::ptrdiff_t stride = s.stride;
  const auto take = [&](Offset offset, const Lanes<T>* half, int minima) STEREO_SGMP_INLINE_ATTR {
    PrefetchPixel(shape, ahead - offset * stride);
    sums->Take(offset, half, minima);
  };
  hwy::Prefetch(s.minimum_sum - sums->start());
  ForEachPixel<T, kPaths>(s, shape, take);
  sums->Complete();
}

template <class T, int kPaths, class Shape>
void Last(const SweepStretch<T>& s) {
  const Shape shape(s.disparities, s.all_disparities);
  StretchSums<T, Shape> sums(s, shape);
  CompleteSums<T, kPaths>(s, shape, &sums);
  WinnerReader<T, Shape>(s, shape, sums).Read();
}

// 0.12 (S - min S) of 16-bit numbers, with 0.12 as 31 parts of 256.
template <class T>
HWY_INLINE Lanes16 RaisedPart(Lanes16 above) {
  const Tag16 d;
  constexpr std::uint16_t kWeight = 31 * kSumStep<T>;
  constexpr std::uint16_t kLimit = 0xFFFF / kWeight;  // its product fits 16 bits
  const Lanes16 limited = hn::Min(above, hn::Set(d, kLimit));
  return hn::ShiftRight<8>(hn::Mul(limited, hn::Set(d, kWeight)));
}

// The same of numbers of T; bytes one half of the lanes after the other.
template <class T>
HWY_INLINE Lanes<T> Raised(Lanes<T> above) {
  if constexpr (sizeof(T) == 2) {
    return RaisedPart<T>(above);
  } else if constexpr (HWY_TARGET == HWY_SCALAR) {
    const hn::Rebind<std::int16_t, Tag<T>> as_signed;
    const Lanes16 raised = RaisedPart<T>(hn::PromoteTo(Tag16(), above));
    return hn::DemoteTo(Tag<T>(), hn::BitCast(as_signed, raised));
  } else {
    const Tag16 d;
    const Lanes16 pairs = hn::BitCast(d, above);
    const Lanes16 even = RaisedPart<T>(hn::And(pairs, hn::Set(d, std::uint16_t{0xFF})));
    const Lanes16 odd = RaisedPart<T>(hn::ShiftRight<8>(pairs));
    return hn::BitCast(Tag<T>(), hn::Or(even, hn::ShiftLeft<8>(odd)));
  }
}

// Costs of one vector for the second round.
HWY_INLINE void StoreSharpened(Lanes<std::uint8_t> raised, int limit, const std::uint8_t* cost,
                               std::uint8_t* sharpened) {
  const Tag<std::uint8_t> d;
  // Half of the costs: their mean with nothing, rounded up, of one less.
  const auto half = hn::AverageRound(
      hn::SaturatedSub(hn::Load(d, cost), hn::Set(d, std::uint8_t{1})), hn::Zero(d));
  const auto sum = hn::SaturatedAdd(raised, half);
  hn::StoreU(hn::Min(sum, hn::Set(d, static_cast<std::uint8_t>(limit))), d, sharpened);
}

HWY_INLINE void StoreSharpened(Lanes16 raised, int limit, const std::uint8_t* cost,
                               std::uint8_t* sharpened) {
  const Tag16 d;
  const hn::Rebind<std::uint8_t, Tag16> narrow;
  const hn::Rebind<std::int16_t, Tag16> as_signed;
  const Lanes16 half = hn::ShiftRight<1>(hn::PromoteTo(d, hn::Load(narrow, cost)));
  const Lanes16 most = hn::Set(d, static_cast<std::uint16_t>(limit));
  const Lanes16 sum = hn::Min(hn::Add(raised, half), most);
  hn::StoreU(hn::DemoteTo(narrow, hn::BitCast(as_signed, sum)), narrow, sharpened);
}

template <class T, int kPaths, class Shape>
void Sharpen(const SweepStretch<T>& s) {
  const Shape shape(s.disparities, s.all_disparities);
  StretchSums<T, Shape> sums(s, shape);
  CompleteSums<T, kPaths>(s, shape, &sums);
  HWY_ALIGN T least[StretchSums<T, Shape>::kPixels];
  sums.StoreLeast(least);
  for (int place = 0; place < sums.count(); ++place) {
    const Lanes<T> best = hn::Set(Tag<T>(), least[place]);
    const std::ptrdiff_t pixel = (place - sums.start()) * s.stride;
    for (int v = 0; v < shape.Count(); ++v) {
      const std::ptrdiff_t k = pixel + v * kLanes<T>;
      StoreSharpened(Raised<T>(hn::Sub(sums.Vector(place, v), best)), 255 / s.unit, s.cost + k,
                     s.sharpened + k);
    }
  }
}

template <class T, int kPaths, class Shape>
void SweepPart(const SweepStretch<T>& s) {
  switch (s.kind) {
    case SweepKind::kStates:
      if constexpr (!Shape::kIsFull) States<T, kPaths, Shape>(s);
      return;
    case SweepKind::kFirst:
      return First<T, kPaths, Shape>(s);
    case SweepKind::kSharpen:
      // The first round has two paths a sweep.
      if constexpr (kPaths != kPathsPerSweep) Sharpen<T, kPaths, Shape>(s);
      return;
    case SweepKind::kLast:
      return Last<T, kPaths, Shape>(s);
  }
}

template <class T, int kPaths, int kVectors>
void SweepVectors(const SweepStretch<T>& s) {
  // The right window may hold indices of pixels that reach more disparities.
  if constexpr (sizeof(T) == 1 && kVectors != kAnyVectors &&
                kVectors * kLanes<T> <= kMostByteIndices) {
    if (s.kind == SweepKind::kLast && s.all_disparities > kMostByteIndices)
      return SweepPart<T, kPaths, PixelShape<T, kAnyVectors, false>>(s);
  }
  // Not for what is rare: each shape takes seconds to compile.
  if constexpr (kPaths == kPathsPerSweep && kVectors != kAnyVectors) {
    if (s.kind != SweepKind::kStates && s.disparities % kLanes<T> == 0)
      return SweepPart<T, kPaths, PixelShape<T, kVectors, true>>(s);
  }
  return SweepPart<T, kPaths, PixelShape<T, kVectors, false>>(s);
}

// 192, 256 and 320 disparities in vectors of 32; longer vectors need fewer.
template <class T>
constexpr int UnrolledFor32(int vectors) {
  return kLanes<T> == 32 ? vectors : kAnyVectors;
}

// Unrolls the loops over the vectors of a pixel: those of 8 bit messages for usual ranges.
template <class T, int kPaths>
void SweepOf(const SweepStretch<T>& s) {
  if constexpr (sizeof(T) == 1) {
    switch ((s.disparities + kLanes<T> - 1) / kLanes<T>) {
      case 1:
        return SweepVectors<T, kPaths, 1>(s);
      case 2:
        return SweepVectors<T, kPaths, 2>(s);
      case 3:
        return SweepVectors<T, kPaths, 3>(s);
      case 4:
        return SweepVectors<T, kPaths, 4>(s);
      case 5:
        return SweepVectors<T, kPaths, 5>(s);
      case 6:
        return SweepVectors<T, kPaths, UnrolledFor32<T>(6)>(s);
      case 8:
        return SweepVectors<T, kPaths, UnrolledFor32<T>(8)>(s);
      case 10:
        return SweepVectors<T, kPaths, UnrolledFor32<T>(10)>(s);
      default:
        break;
    }
  }
  return SweepVectors<T, kPaths, kAnyVectors>(s);
}

}  // namespace HWY_NAMESPACE
}  // namespace stereo_sgmp
HWY_AFTER_NAMESPACE();

#endif  // per-target include guard
