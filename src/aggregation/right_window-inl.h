// The winners of the right image, as the last sweep goes through a row of the left one.
#if defined(STEREO_SGMP_AGGREGATION_RIGHT_WINDOW_INL_H_) == defined(HWY_TARGET_TOGGLE)
#ifdef STEREO_SGMP_AGGREGATION_RIGHT_WINDOW_INL_H_
#undef STEREO_SGMP_AGGREGATION_RIGHT_WINDOW_INL_H_
#else
#define STEREO_SGMP_AGGREGATION_RIGHT_WINDOW_INL_H_
#endif

#include <hwy/highway.h>

#include <cstdint>
#include <limits>

#include "aggregation/lanes-inl.h"
#include "aggregation/sweep_kernel.h"

HWY_BEFORE_NAMESPACE();
namespace stereo_sgmp {
namespace HWY_NAMESPACE {
namespace hn = hwy::HWY_NAMESPACE;

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
template <class T, class Shape>
class RightWindow {
 public:
  RightWindow(const SweepStretch<T>& s, const Shape& shape) : s_(s), shape_(shape) {
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

  // After the offers of a left pixel: returns the winner of the right pixel that is done with, a
  // disparity index or WinnerMap::kNone.
  HWY_INLINE std::uint16_t Leave() {
    const std::uint16_t winner = FirstWinner();
    const Lanes<T> none = hn::Set(Tag<T>(), kNoOffer);
    Shift(none, best_);
    for (int part = 0; part < kIndexParts; ++part) Shift(none, index_[part]);
    return winner;
  }

  // Leaves the window to the next stretch or, at the end of the row, the winners to the image. `x`
  // is that of the last left pixel.
  HWY_INLINE void Finish(int x) {
    if (s_.u_end == s_.width) {
      for (int right = x - 1 - s_.right.min_disparity; right >= 0; --right) {
        const std::uint16_t winner = Leave();
        if (right < s_.width) s_.right.winner[right] = winner;
      }
      return;
    }
    for (int v = 0; v < Count(); ++v) {
      hn::Store(best_[v], Tag<T>(), s_.right.best + v * kLanes<T>);
      for (int part = 0; part < kIndexParts; ++part) {
        hn::Store(index_[part][v], Tag<T>(), IndexPart(part) + v * kLanes<T>);
      }
      // The next stretch may have another shape, which reads both bytes.
      if constexpr (sizeof(T) == 1 && kIndexParts == 1) {
        hn::Store(hn::Zero(Tag<T>()), Tag<T>(), IndexPart(1) + v * kLanes<T>);
      }
    }
  }

 private:
  static constexpr T kNoOffer = std::numeric_limits<T>::max();
  static constexpr int kMost = Shape::kMost;
  // Indices beyond 255 take two bytes, of which each is kept for itself.
  static constexpr int kIndexParts = sizeof(T) == 1 && kMost * kLanes<T> > 256 ? 2 : 1;

  HWY_INLINE int Count() const { return shape_.Count(); }
  HWY_INLINE T* IndexPart(int part) const { return s_.right.index + part * s_.stride; }

  static HWY_INLINE Lanes<T> IndicesOf(int part, int v) {
    const Tag<T> d;
    const int first = v * kLanes<T>;
    return part == 0 ? hn::Iota(d, static_cast<T>(first)) : hn::Set(d, static_cast<T>(first >> 8));
  }

  HWY_INLINE std::uint16_t FirstWinner() const {
    if (hn::GetLane(best_[0]) == kNoOffer) return WinnerMap::kNone;
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
  const Shape& shape_;
  Lanes<T> best_[kMost];
  Lanes<T> index_[kIndexParts][kMost];
};

}  // namespace HWY_NAMESPACE
}  // namespace stereo_sgmp
HWY_AFTER_NAMESPACE();

#endif  // per-target include guard
