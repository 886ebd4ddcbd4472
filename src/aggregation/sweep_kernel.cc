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

// Of lambdas: what is in vectors has to stay in registers from caller to callee.
#ifndef STEREO_SGMP_INLINE_ATTR
#define STEREO_SGMP_INLINE_ATTR HWY_ATTR __attribute__((always_inline))
#endif

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

// Where S of the i-th pixel is completed.
template <class T>
HWY_INLINE PixelSum<T> TotalOf(const SweepStretch<T>& s, int i, int vectors) {
  return {s.total + i * s.stride, s.stride / PixelSum<T>::kParts, vectors};
}

template <class T, int kPaths, int kVectors>
void First(const SweepStretch<T>& s) {
  const PixelShape<T, kVectors> shape(s.disparities);
  ForEachPixel<T, kPaths, kVectors>(
      s, shape,
      [&](std::ptrdiff_t offset, const Lanes<T>* sums, int minimum_sum) STEREO_SGMP_INLINE_ATTR {
        T* sum = SumOf(s, offset);
        for (int v = 0; v < shape.Count(); ++v) hn::Stream(sums[v], Tag<T>(), sum + v * kLanes<T>);
        s.minimum_sum[offset] = static_cast<std::uint16_t>(minimum_sum);
      });
}

template <class T, int kPaths>
void States(const SweepStretch<T>& s) {
  const PixelShape<T, kAnyVectors> shape(s.disparities);
  ForEachPixel<T, kPaths, kAnyVectors>(
      s, shape, [](std::ptrdiff_t, const Lanes<T>*, int) STEREO_SGMP_INLINE_ATTR {});
}

// S of the pixel less what its paths exceed their least by, in steps of kSumStep.
template <class T>
HWY_INLINE int BaseOf(const SweepStretch<T>& s, std::ptrdiff_t offset, int minimum_sum) {
  return (s.minimum_sum[offset] + minimum_sum) / kSumStep<T>;
}

// One part of a vector of S: both halves and the base.
template <class T, int kPart>
HWY_INLINE Lanes16 CompletePart(Lanes<T> first, Lanes<T> last, Lanes16 base) {
  return hn::Add(base, hn::Add(PartOf<T, kPart>(first), PartOf<T, kPart>(last)));
}

// Completes S of a pixel in `total`: `sums` and the half that was stored.
template <class T, int kVectors>
HWY_INLINE void CompleteSum(const PixelShape<T, kVectors>& shape, const Lanes<T>* sums,
                            const T* stored, int base, int disparities, const PixelSum<T>& total) {
  const Tag16 d;
  const Lanes16 bases = hn::Set(d, static_cast<std::uint16_t>(base));
  const int last = shape.Count() - 1;
  const auto store = [&](int part, int v, Lanes16 complete) STEREO_SGMP_INLINE_ATTR {
    const int k = v * kLanes<std::uint16_t>;
    if (v == last) {
      const int count = (disparities - part + total.kParts - 1) / total.kParts - k;
      complete = hn::Or(complete, hn::LoadU(d, LaneMasks<std::uint16_t>::From(count)));
    }
    hn::Store(complete, d, total.Part(part) + k);
  };
  for (int v = 0; v <= last; ++v) {
    const Lanes<T> half = hn::Load(Tag<T>(), stored + v * kLanes<T>);
    store(0, v, CompletePart<T, 0>(half, sums[v], bases));
    if constexpr (total.kParts == 2) store(1, v, CompletePart<T, 1>(half, sums[v], bases));
  }
}

HWY_INLINE std::uint16_t InOptionUnits(int sum, int unit) {
  return static_cast<std::uint16_t>(sum * unit);
}

// Asks for S of the pixel that comes a few later: there is too much of it for the hardware alone.
template <class T>
HWY_INLINE void PrefetchSum(const SweepStretch<T>& s, std::ptrdiff_t offset) {
  constexpr int kAhead = 4;
  constexpr std::ptrdiff_t kCacheLine = 64 / sizeof(T);
  const T* ahead = SumOf(s, offset + kAhead * s.x_step);
  for (std::ptrdiff_t k = 0; k < s.stride; k += kCacheLine) hwy::Prefetch(ahead + k);
}

// Reads off the complete S of the pixel at image column x.
template <class T>
HWY_INLINE void ReadPixel(const SweepStretch<T>& s, const PixelSum<T>& total, std::ptrdiff_t x,
                          int base) {
  const WinnerRow& out = s.winners;
  const int unit = s.unit * kSumStep<T>;
  const LeastSum least = OfferSum(total, s.right, s.right.x_origin - static_cast<int>(x));
  const std::uint16_t best = least.Sum();
  const int winner = least.Index(best);
  const bool has_below = winner > 0;
  const bool has_above = winner + 1 < s.disparities;
  out.winner[x] = static_cast<std::uint16_t>(winner);
  out.cost[x] = InOptionUnits(best, unit);
  out.cost_below[x] = has_below ? InOptionUnits(total.At(winner - 1), unit) : kNoSum;
  out.cost_above[x] = has_above ? InOptionUnits(total.At(winner + 1), unit) : kNoSum;
  out.uncertainty[x] = InOptionUnits(best - base, unit);
  const std::uint16_t second = SecondBest(total, winner);
  out.second[x] = second == kNoSum ? kNoSum : InOptionUnits(second, unit);
}

// First completes S of all pixels: those steps wait for each other, the reading does not.
template <class T, int kPaths, int kVectors>
void Last(const SweepStretch<T>& s) {
  const PixelShape<T, kVectors> shape(s.disparities);
  int bases[SweepStretch<T>::kMaxPixels];
  int completed = 0;
  ForEachPixel<T, kPaths, kVectors>(
      s, shape,
      [&](std::ptrdiff_t offset, const Lanes<T>* sums, int minimum_sum) STEREO_SGMP_INLINE_ATTR {
        PrefetchSum(s, offset);
        const int base = BaseOf(s, offset, minimum_sum);
        CompleteSum(shape, sums, SumOf(s, offset), base, s.disparities,
                    TotalOf(s, completed, shape.Count()));
        bases[completed++] = base;
      });
  for (int i = 0; i < completed; ++i) {
    ReadPixel(s, TotalOf(s, i, shape.Count()), s.x_first + i * s.x_step, bases[i]);
  }
}

// 0.12 (S - min S), with 0.12 as 31 parts of 256.
template <class T>
HWY_INLINE Lanes16 Raised(Lanes16 sum, Lanes16 best) {
  const Tag16 d;
  constexpr std::uint16_t kWeight = 31 * kSumStep<T>;
  constexpr std::uint16_t kLimit = kNoSum / kWeight;  // its product fits 16 bits
  const Lanes16 above = hn::Min(hn::Sub(sum, best), hn::Set(d, kLimit));
  return hn::ShiftRight<8>(hn::Mul(above, hn::Set(d, kWeight)));
}

// Costs of one vector for the second round, whose S stands at total.Part(0)[k] and, if there is
// one, total.Part(1)[k].
template <class T>
HWY_INLINE void SharpenVector(const PixelSum<T>& total, int k, Lanes16 best, int limit,
                              const std::uint8_t* cost, std::uint8_t* sharpened) {
  const Tag16 d;
  const int place = k * total.kParts;
  const Lanes16 raised = Raised<T>(hn::Load(d, total.Part(0) + k), best);
  if constexpr (total.kParts == 2) {
    const Tag<T> bytes;
    const Lanes16 odd = Raised<T>(hn::Load(d, total.Part(1) + k), best);
    const Lanes<T> both = hn::BitCast(bytes, hn::Or(raised, hn::ShiftLeft<8>(odd)));
    const Lanes16 pairs = hn::BitCast(d, hn::Load(bytes, cost + place));
    const Lanes16 halves = hn::And(hn::ShiftRight<1>(pairs), hn::Set(d, std::uint16_t{0x7F7F}));
    const Lanes<T> sum = hn::SaturatedAdd(both, hn::BitCast(bytes, halves));
    hn::StoreU(hn::Min(sum, hn::Set(bytes, static_cast<T>(limit))), bytes, sharpened + place);
  } else {
    const hn::Rebind<std::uint8_t, Tag16> narrow;
    const hn::Rebind<std::int16_t, Tag16> as_signed;
    const Lanes16 half = hn::ShiftRight<1>(hn::PromoteTo(d, hn::Load(narrow, cost + place)));
    const Lanes16 most = hn::Set(d, static_cast<std::uint16_t>(limit));
    const Lanes16 sum = hn::Min(hn::Add(raised, half), most);
    hn::StoreU(hn::DemoteTo(narrow, hn::BitCast(as_signed, sum)), narrow, sharpened + place);
  }
}

template <class T, int kPaths, int kVectors>
void Sharpen(const SweepStretch<T>& s) {
  const Tag16 d;
  const PixelShape<T, kVectors> shape(s.disparities);
  const PixelSum<T> total = TotalOf(s, 0, shape.Count());
  ForEachPixel<T, kPaths, kVectors>(
      s, shape, [&](std::ptrdiff_t offset, const Lanes<T>* sums, int) STEREO_SGMP_INLINE_ATTR {
        const std::ptrdiff_t place = offset * s.stride;
        // Only differences of S matter here.
        CompleteSum(shape, sums, SumOf(s, offset), 0, s.disparities, total);
        const Lanes16 best = hn::Set(d, LeastOf(total));
        for (int v = 0; v < shape.Count(); ++v) {
          SharpenVector(total, v * kLanes<std::uint16_t>, best, 255 / s.unit, s.cost + place,
                        s.sharpened + place);
        }
      });
}

template <class T, int kPaths, int kVectors>
void SweepVectors(const SweepStretch<T>& s) {
  switch (s.kind) {
    case SweepKind::kStates:
      return States<T, kPaths>(s);
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
  const int vectors = sizeof(T) == 1 ? PixelShape<T, kAnyVectors>(s.disparities).vectors : 0;
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

int Parts8() { return SumLayout<std::uint8_t>::kParts; }
int Parts16() { return SumLayout<std::uint16_t>::kParts; }

}  // namespace HWY_NAMESPACE
}  // namespace stereo_sgmp
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace stereo_sgmp {

HWY_EXPORT(Sweep8);
HWY_EXPORT(Sweep16);
HWY_EXPORT(Parts8);
HWY_EXPORT(Parts16);

void SweepPixels(const SweepStretch<std::uint8_t>& stretch) {
  HWY_DYNAMIC_DISPATCH(Sweep8)(stretch);
}

void SweepPixels(const SweepStretch<std::uint16_t>& stretch) {
  HWY_DYNAMIC_DISPATCH(Sweep16)(stretch);
}

template <class T>
void ReadRightWinners(const RightRow& right, int first, int count, std::uint16_t* winners) {
  const int parts =
      sizeof(T) == 1 ? HWY_DYNAMIC_DISPATCH(Parts8)() : HWY_DYNAMIC_DISPATCH(Parts16)();
  for (int i = 0; i < count; ++i) {
    const std::ptrdiff_t offset = right.Offset(first - i, parts);
    winners[i] = right.cost[offset] == WinnerMap::kNone ? WinnerMap::kNone : right.winner[offset];
  }
}

template void ReadRightWinners<std::uint8_t>(const RightRow&, int, int, std::uint16_t*);
template void ReadRightWinners<std::uint16_t>(const RightRow&, int, int, std::uint16_t*);

}  // namespace stereo_sgmp
#endif  // HWY_ONCE
