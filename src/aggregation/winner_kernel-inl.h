// What the last sweep reads off the complete S of a pixel: winner, second best, right image.
#if defined(STEREO_SGMP_AGGREGATION_WINNER_KERNEL_INL_H_) == defined(HWY_TARGET_TOGGLE)
#ifdef STEREO_SGMP_AGGREGATION_WINNER_KERNEL_INL_H_
#undef STEREO_SGMP_AGGREGATION_WINNER_KERNEL_INL_H_
#else
#define STEREO_SGMP_AGGREGATION_WINNER_KERNEL_INL_H_
#endif

#include <hwy/highway.h>

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <limits>

#include "aggregation/lane_masks.h"
#include "aggregation/lanes-inl.h"
#include "aggregation/message_kernel-inl.h"
#include "aggregation/sweep_kernel.h"

HWY_BEFORE_NAMESPACE();
namespace stereo_sgmp {
namespace HWY_NAMESPACE {
namespace hn = hwy::HWY_NAMESPACE;

// What S of one pixel exceeds its base by, for each disparity index; the largest number beyond the
// last one.
template <class T>
struct PixelExcess {
  static constexpr T kMost = std::numeric_limits<T>::max();

  const T* first;
  int vectors;

  HWY_INLINE Lanes<T> Vector(int v) const { return hn::Load(Tag<T>(), first + v * kLanes<T>); }
};

// What S of a pixel exceeds, in steps of kSumStep: the sum of what the paths cost at least, and the
// base that PixelExcess counts from.
struct SumBase {
  int path_minima;
  int sum;
};

// The least excess, in all lanes.
template <class T>
HWY_INLINE Lanes<T> LeastOf(const PixelExcess<T>& excess) {
  const Tag<T> d;
  Lanes<T> least = hn::Set(d, PixelExcess<T>::kMost);
  for (int v = 0; v < excess.vectors; ++v) least = hn::Min(least, excess.Vector(v));
  return SmallestOfLanes(d, least);
}

// Smallest index with the excess `value`, which there has to be.
template <class T>
HWY_INLINE int FirstWith(const PixelExcess<T>& excess, Lanes<T> value) {
  const Tag<T> d;
  int first = 0;
  for (int v = excess.vectors - 1; v >= 0; --v) {
    const auto lane = hn::FindFirstTrue(d, hn::Eq(excess.Vector(v), value));
    first = lane >= 0 ? v * kLanes<T> + static_cast<int>(lane) : first;
  }
  return first;
}

// Least excess further than one from `winner`; PixelExcess::kMost if there is none.
template <class T>
HWY_INLINE T SecondBest(const PixelExcess<T>& excess, int winner) {
  const Tag<T> d;
  const T* near = NearMasks<T>::Around(winner);
  Lanes<T> least = hn::Set(d, PixelExcess<T>::kMost);
  for (int v = 0; v < excess.vectors; ++v) {
    const Lanes<T> is_near = hn::LoadU(d, near + v * kLanes<T>);
    least = hn::Min(least, hn::Or(excess.Vector(v), is_near));
  }
  return SmallestLane(d, least);
}

// What decides between the left pixels that match one right pixel: their S, in bytes in steps twice
// as large, so that walls on which the paths disagree don't reach the largest number.
template <class T>
HWY_INLINE Lanes<T> OfferOf(Lanes<T> excess, Lanes<T> base) {
  if constexpr (sizeof(T) == 1) {
    return hn::AverageRound(excess, base);
  } else {
    return hn::SaturatedAdd(excess, base);
  }
}

// The right pixels that a left one can match, lane k that at disparity index k: the least offer
// so far, and its index. The sweep goes through the row with x falling, so the match in the first
// lane is done with after each pixel and all others move by a lane. It meets the disparities of a
// right pixel from large to small: of equal offers the later has the smaller index.
template <class T, int kVectors>
class RightWindow {
 public:
  explicit RightWindow(const SweepStretch<T>& s, int vectors) : s_(s), vectors_(vectors) {
    for (int v = 0; v < Count(); ++v) {
      best_[v] = hn::Load(Tag<T>(), s.right.best + v * kLanes<T>);
      for (int part = 0; part < kIndexParts; ++part) {
        index_[part][v] = hn::Load(Tag<T>(), IndexPart(part) + v * kLanes<T>);
      }
    }
  }

  // Of the disparity indices of vector v. The largest number is no offer.
  HWY_INLINE void Offer(int v, Lanes<T> offer) {
    best_[v] = hn::Min(offer, best_[v]);
    const auto takes = hn::Eq(best_[v], offer);
    for (int part = 0; part < kIndexParts; ++part) {
      index_[part][v] = hn::IfThenElse(takes, IndicesOf(part, v), index_[part][v]);
    }
  }

  // After the offers of the left pixel x.
  HWY_INLINE void Leave(int x) {
    const int x_right = x - s_.right.min_disparity;
    if (static_cast<unsigned>(x_right) < static_cast<unsigned>(s_.width)) {
      s_.right.winner[x_right] = FirstWinner();
    }
    const Lanes<T> none = hn::Set(Tag<T>(), PixelExcess<T>::kMost);
    Shift(none, best_);
    for (int part = 0; part < kIndexParts; ++part) Shift(none, index_[part]);
  }

  // Leaves the window to the next stretch or, at the end of the row, the winners to the image.
  HWY_INLINE void Finish(int x) {
    if (s_.u_end == s_.width) {
      for (; x > s_.right.min_disparity; --x) Leave(x - 1);
      return;
    }
    for (int v = 0; v < Count(); ++v) {
      hn::Store(best_[v], Tag<T>(), s_.right.best + v * kLanes<T>);
      for (int part = 0; part < kIndexParts; ++part) {
        hn::Store(index_[part][v], Tag<T>(), IndexPart(part) + v * kLanes<T>);
      }
    }
  }

 private:
  static constexpr int kMost = PixelShape<T, kVectors>::kMost;
  // Indices beyond 255 take two bytes, of which each is kept for itself.
  static constexpr int kIndexParts = sizeof(T) == 1 && kMost * kLanes<T> > 256 ? 2 : 1;

  HWY_INLINE int Count() const { return kVectors != kAnyVectors ? kVectors : vectors_; }
  HWY_INLINE T* IndexPart(int part) const { return s_.right.index + part * s_.stride; }

  static HWY_INLINE Lanes<T> IndicesOf(int part, int v) {
    const Tag<T> d;
    const int first = v * kLanes<T>;
    return part == 0 ? hn::Iota(d, static_cast<T>(first)) : hn::Set(d, static_cast<T>(first >> 8));
  }

  HWY_INLINE std::uint16_t FirstWinner() const {
    if (hn::GetLane(best_[0]) == PixelExcess<T>::kMost) return WinnerMap::kNone;
    unsigned index = hn::GetLane(index_[0][0]);
    if constexpr (kIndexParts == 2) index |= unsigned{hn::GetLane(index_[1][0])} << 8;
    return static_cast<std::uint16_t>(index);
  }

  HWY_INLINE void Shift(Lanes<T> behind, Lanes<T>* vectors) const {
    for (int v = 0; v < Count(); ++v) {
      vectors[v] = FromAbove<T>(vectors[v], v + 1 < Count() ? vectors[v + 1] : behind);
    }
  }

  const SweepStretch<T>& s_;
  int vectors_;
  Lanes<T> best_[kMost];
  Lanes<T> index_[kIndexParts][kMost];
};

// Reads off the excess of a pixel, and offers its S to the right image.
template <class T, int kVectors>
HWY_INLINE void ReadPixel(const SweepStretch<T>& s, const PixelExcess<T>& excess, int x,
                          const SumBase& base, RightWindow<T, kVectors>* right) {
  const Tag<T> d;
  const WinnerRow& out = s.winners;
  const int unit = s.unit * kSumStep<T>;
  const auto in_option_units = [&](int sum) STEREO_SGMP_INLINE_ATTR {
    return static_cast<std::uint16_t>(sum * unit);
  };
  const Lanes<T> bases = hn::Set(d, static_cast<T>(std::min<int>(base.sum, PixelExcess<T>::kMost)));
  for (int v = 0; v < excess.vectors; ++v) {
    right->Offer(v, OfferOf<T>(excess.Vector(v), bases));
  }
  right->Leave(x);
  const Lanes<T> least = LeastOf(excess);
  const int best = hn::GetLane(least);
  const int winner = FirstWith(excess, least);
  const bool has_below = winner > 0;
  const bool has_above = winner + 1 < s.disparities;
  const bool has_second = winner > 1 || winner + 2 < s.disparities;
  out.winner[x] = static_cast<std::uint16_t>(winner);
  out.cost[x] = in_option_units(base.sum + best);
  out.cost_below[x] =
      has_below ? in_option_units(base.sum + excess.first[winner - 1]) : WinnerMap::kNone;
  out.cost_above[x] =
      has_above ? in_option_units(base.sum + excess.first[winner + 1]) : WinnerMap::kNone;
  out.uncertainty[x] = in_option_units(base.sum + best - base.path_minima);
  const int second = SecondBest(excess, winner);
  out.second[x] = has_second ? in_option_units(base.sum + second) : WinnerMap::kNone;
}

}  // namespace HWY_NAMESPACE
}  // namespace stereo_sgmp
HWY_AFTER_NAMESPACE();

#endif  // per-target include guard
