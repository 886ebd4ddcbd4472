// With the byte shuffles of newer processors, for one step of the disparities.
#ifndef HWY_WANT_AVX3_DL
#define HWY_WANT_AVX3_DL
#endif

#include "aggregation/sweep_kernel.h"

#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "aggregation/sweep_kernel.cc"
#include <hwy/cache_control.h>
#include <hwy/foreach_target.h>
#include <hwy/highway.h>

#include "aggregation/lanes-inl.h"
#include "aggregation/message_kernel-inl.h"
#include "aggregation/step_kernel-inl.h"
#include "aggregation/winner_kernel-inl.h"

HWY_BEFORE_NAMESPACE();
namespace stereo_sgmp {
namespace HWY_NAMESPACE {
namespace hn = hwy::HWY_NAMESPACE;

// Moves along a stretch; calls `finish(offset, sums, minimum_sum)` for each pixel, which stands
// `offset` pixels from the first one.
template <class T, int kPaths, int kVectors, class Finish>
HWY_INLINE void ForEachPixel(const SweepStretch<T>& s, const PixelShape<T, kVectors>& shape,
                             const Finish& finish) {
  StepCursor<T, kPaths> cursor(s);
  for (int u = s.u_begin; u < s.u_end; ++u) {
    const std::ptrdiff_t offset = static_cast<std::ptrdiff_t>(u - s.u_begin) * s.x_step;
    PathStepState<T> paths[kPaths];
    cursor.Prepare(u, offset, paths);
    Lanes<T> sums[PixelShape<T, kVectors>::kMost];
    const int minimum_sum =
        AdvancePaths<T, kPaths, kVectors>(shape, paths, s.cost + offset * s.stride, s.p1, sums);
    if (HWY_UNLIKELY(shape.Count() < shape.all_vectors)) SendUnreached(shape, paths);
    cursor.Advance();
    finish(offset, sums, minimum_sum);
  }
  cursor.Finish();
}

// S of the pixel `offset` pixels from the first one: it is stored from the last pixel of the image
// to the first, so that the backward sweep, which has to wait for it, reads on and on.
template <class T>
HWY_INLINE T* SumOf(const SweepStretch<T>& s, std::ptrdiff_t offset) {
  return s.sum - offset * s.stride;
}

template <class T, int kPaths, int kVectors>
void First(const SweepStretch<T>& s) {
  const PixelShape<T, kVectors> shape(s.disparities, s.all_disparities);
  ForEachPixel<T, kPaths, kVectors>(
      s, shape,
      [&](std::ptrdiff_t offset, const Lanes<T>* sums, int minimum_sum) STEREO_SGMP_INLINE_ATTR {
        T* sum = SumOf(s, offset);
        for (int v = 0; v < shape.Count(); ++v) hn::Stream(sums[v], Tag<T>(), sum + v * kLanes<T>);
        s.minimum_sum[offset] = static_cast<std::uint16_t>(minimum_sum);
      });
}

template <class T, int kPaths, int kVectors>
void States(const SweepStretch<T>& s) {
  const PixelShape<T, kVectors> shape(s.disparities, s.all_disparities);
  ForEachPixel<T, kPaths, kVectors>(
      s, shape, [](std::ptrdiff_t, const Lanes<T>*, int) STEREO_SGMP_INLINE_ATTR {});
}

// Completes S of a pixel from `sums` and the half that was stored: `excess` receives what it
// exceeds the least of both halves by. Returns the latter.
template <class T, int kVectors>
HWY_INLINE int CompleteExcess(const PixelShape<T, kVectors>& shape, const Lanes<T>* sums,
                              const T* stored, T* excess) {
  const Tag<T> d;
  const int last = shape.Count() - 1;
  Lanes<T> first_half[PixelShape<T, kVectors>::kMost];
  Lanes<T> least_of_first = hn::Set(d, PixelExcess<T>::kMost);
  Lanes<T> least_of_last = least_of_first;
  for (int v = 0; v <= last; ++v) {
    first_half[v] = hn::Load(d, stored + v * kLanes<T>);
    const Lanes<T> unused = v == last ? shape.tail : hn::Zero(d);
    least_of_first = hn::Min(least_of_first, hn::Or(first_half[v], unused));
    least_of_last = hn::Min(least_of_last, hn::Or(sums[v], unused));
  }
  least_of_first = SmallestOfLanes(d, least_of_first);
  least_of_last = SmallestOfLanes(d, least_of_last);
  for (int v = 0; v <= last; ++v) {
    Lanes<T> complete =
        hn::SaturatedAdd(hn::Sub(first_half[v], least_of_first), hn::Sub(sums[v], least_of_last));
    if (v == last) complete = hn::Or(complete, shape.tail);
    hn::Store(complete, d, excess + v * kLanes<T>);
  }
  return int{hn::GetLane(least_of_first)} + int{hn::GetLane(least_of_last)};
}

// Asks for S of the pixel that comes a few later: there is too much of it for the hardware alone.
template <class T>
HWY_INLINE void PrefetchSum(const SweepStretch<T>& s, std::ptrdiff_t offset) {
  constexpr int kAhead = 4;
  constexpr std::ptrdiff_t kCacheLine = 64 / sizeof(T);
  const T* ahead = SumOf(s, offset + kAhead * s.x_step);
  for (std::ptrdiff_t k = 0; k < s.stride; k += kCacheLine) hwy::Prefetch(ahead + k);
}

// First completes S of all pixels: those steps wait for each other, the reading does not.
template <class T, int kPaths, int kVectors>
void Last(const SweepStretch<T>& s) {
  const PixelShape<T, kVectors> shape(s.disparities, s.all_disparities);
  SumBase bases[SweepStretch<T>::kMaxPixels];
  int completed = 0;
  ForEachPixel<T, kPaths, kVectors>(
      s, shape,
      [&](std::ptrdiff_t offset, const Lanes<T>* sums, int minimum_sum) STEREO_SGMP_INLINE_ATTR {
        PrefetchSum(s, offset);
        const int path_minima = (s.minimum_sum[offset] + minimum_sum) / kSumStep<T>;
        const int excess =
            CompleteExcess(shape, sums, SumOf(s, offset), s.excess + completed * s.stride);
        bases[completed++] = {path_minima, path_minima + excess};
      });
  RightWindow<T, kVectors> right(s, shape.Count());
  int x = s.x_first;
  for (int i = 0; i < completed; ++i, --x) {
    ReadPixel(s, PixelExcess<T>{s.excess + i * s.stride, shape.Count()}, x, bases[i], &right);
  }
  right.Finish(x + 1);
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

template <class T, int kPaths, int kVectors>
void Sharpen(const SweepStretch<T>& s) {
  const PixelShape<T, kVectors> shape(s.disparities, s.all_disparities);
  const PixelExcess<T> excess{s.excess, shape.Count()};
  ForEachPixel<T, kPaths, kVectors>(
      s, shape, [&](std::ptrdiff_t offset, const Lanes<T>* sums, int) STEREO_SGMP_INLINE_ATTR {
        const std::ptrdiff_t place = offset * s.stride;
        CompleteExcess(shape, sums, SumOf(s, offset), s.excess);
        const Lanes<T> best = LeastOf(excess);
        for (int v = 0; v < shape.Count(); ++v) {
          const std::ptrdiff_t k = place + v * kLanes<T>;
          StoreSharpened(Raised<T>(hn::Sub(excess.Vector(v), best)), 255 / s.unit, s.cost + k,
                         s.sharpened + k);
        }
      });
}

template <class T, int kPaths, int kVectors>
void SweepVectors(const SweepStretch<T>& s) {
  switch (s.kind) {
    case SweepKind::kStates:
      return States<T, kPaths, kVectors>(s);
    case SweepKind::kFirst:
      return First<T, kPaths, kVectors>(s);
    case SweepKind::kSharpen:
      // The first round has two paths a sweep.
      if constexpr (kPaths != kPathsPerSweep) Sharpen<T, kPaths, kVectors>(s);
      return;
    case SweepKind::kLast:
      return Last<T, kPaths, kVectors>(s);
  }
}

// Unrolls the loops over the vectors of a pixel: those of 8 bit messages for usual ranges.
template <class T, int kPaths>
void SweepOf(const SweepStretch<T>& s) {
  const int vectors = sizeof(T) == 1 ? PixelShape<T, kAnyVectors>::VectorsOf(s.disparities) : 0;
  switch (vectors) {
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
    case 8:
      // 256 disparities in vectors of 32; longer vectors need fewer.
      if constexpr (kLanes<T> == 32) return SweepVectors<T, kPaths, 8>(s);
      [[fallthrough]];
    default:
      return SweepVectors<T, kPaths, kAnyVectors>(s);
  }
}

template <class T>
void SweepAll(const SweepStretch<T>& s) {
  return s.paths == kPathsPerSweep ? SweepOf<T, kPathsPerSweep>(s) : SweepOf<T, 2>(s);
}

void Sweep8(const SweepStretch<std::uint8_t>& s) { SweepAll(s); }
void Sweep16(const SweepStretch<std::uint16_t>& s) { SweepAll(s); }

}  // namespace HWY_NAMESPACE
}  // namespace stereo_sgmp
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace stereo_sgmp {

HWY_EXPORT(Sweep8);
HWY_EXPORT(Sweep16);

void SweepPixels(const SweepStretch<std::uint8_t>& stretch) {
  HWY_DYNAMIC_DISPATCH(Sweep8)(stretch);
}

void SweepPixels(const SweepStretch<std::uint16_t>& stretch) {
  HWY_DYNAMIC_DISPATCH(Sweep16)(stretch);
}

}  // namespace stereo_sgmp
#endif  // HWY_ONCE
