// The winners of the right image, as the last sweep goes through a row of the left one.
#if defined(STEREO_SGMP_AGGREGATION_RIGHT_WINDOW_INL_H_) == defined(HWY_TARGET_TOGGLE)
#ifdef STEREO_SGMP_AGGREGATION_RIGHT_WINDOW_INL_H_
#undef STEREO_SGMP_AGGREGATION_RIGHT_WINDOW_INL_H_
#else
#define STEREO_SGMP_AGGREGATION_RIGHT_WINDOW_INL_H_
#endif

#include <hwy/highway.h>

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <limits>

#include "aggregation/lanes-inl.h"
#include "aggregation/sweep_kernel.h"
#include "common/numbers-inl.h"

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

// Indices up to here take one byte, those beyond two, of which each is kept for itself. A window
// that shrinks may hold indices beyond its lanes.
inline constexpr int kMostByteIndices = 256;

// The winners of all right pixels in a window of `lanes`, of which `first` stands in the first
// lane, the one to its left in the second and so on.
template <class T>
HWY_NOINLINE void WriteRightWinners(const SweepStretch<T>& s, int lanes, int first) {
  const RightRow<T>& right = s.right;
  const int end = std::min(lanes, first + 1);
  for (int lane = std::max(0, first - s.width + 1); lane < end; ++lane) {
    if (right.best[lane] == std::numeric_limits<T>::max()) continue;
    unsigned index = right.index[lane];
    if constexpr (sizeof(T) == 1) index |= unsigned{right.index[s.stride + lane]} << 8;
    right.winner[first - lane] = static_cast<std::uint16_t>(index);
  }
}

// The right pixels that a left one can match, lane k that at disparity index k: the least offer
// so far, and its index. From one left pixel of the row to the next all move by a lane. Going
// forward, each meets its disparities from small to large and leaves behind the last lane; going
// backward, from large to small, and leaves before the first. Of equal offers the one of the
// smaller index stays.
template <class T, class Shape, bool kForward>
class RightWindow {
 public:
  RightWindow(const SweepStretch<T>& s, const Shape& shape) : s_(s), shape_(shape) {
    ForEachVector([&](int v) STEREO_SGMP_INLINE_ATTR {
      best_[v] = hn::Load(Tag<T>(), s_.right.best + v * kLanes<T>);
      ForEachPart([&](int part) STEREO_SGMP_INLINE_ATTR {
        index_[part][v] = hn::Load(Tag<T>(), IndexPart(part) + v * kLanes<T>);
      });
    });
  }

  // Of the disparity indices of vector v. The largest number is no offer.
  HWY_INLINE void Offer(int v, Lanes<T> offer) {
    const Lanes<T> best = hn::Min(offer, best_[v]);
    const auto stays = kForward ? hn::Eq(best, best_[v]) : hn::Ne(best, offer);
    best_[v] = best;
    ForEachPart([&](int part) STEREO_SGMP_INLINE_ATTR {
      index_[part][v] = hn::IfThenElse(stays, index_[part][v], IndicesOf(part, v));
    });
  }

  // On to the next left pixel: returns the winner of the right pixel that leaves, a disparity index
  // or WinnerMap::kNone.
  HWY_INLINE std::uint16_t Move() {
    const std::uint16_t winner = LeavingWinner();
    Shift(hn::Set(Tag<T>(), kNoOffer), best_);
    ForEachPart([&](int part) STEREO_SGMP_INLINE_ATTR { Shift(hn::Zero(Tag<T>()), index_[part]); });
    return winner;
  }

  // Leaves the window to the next stretch or, at the end of the row, the winners to the image.
  // `first` is the right pixel in the first lane.
  HWY_INLINE void Finish(int first) {
    ForEachVector([&](int v) STEREO_SGMP_INLINE_ATTR {
      hn::Store(best_[v], Tag<T>(), s_.right.best + v * kLanes<T>);
      ForEachPart([&](int part) STEREO_SGMP_INLINE_ATTR {
        hn::Store(index_[part][v], Tag<T>(), IndexPart(part) + v * kLanes<T>);
      });
      // The next stretch may have another shape, which reads both bytes.
      if constexpr (sizeof(T) == 1 && kIndexParts == 1) {
        hn::Store(hn::Zero(Tag<T>()), Tag<T>(), IndexPart(1) + v * kLanes<T>);
      }
    });
    if (s_.u_end == s_.width) WriteRightWinners<T>(s_, Count() * kLanes<T>, first);
  }

 private:
  static constexpr T kNoOffer = std::numeric_limits<T>::max();
  static constexpr int kMost = Shape::kMost;
  static constexpr int kIndexParts = sizeof(T) == 1 && kMost * kLanes<T> > kMostByteIndices ? 2 : 1;

  HWY_INLINE int Count() const { return shape_.Count(); }

  template <class Use>
  HWY_INLINE void ForEachVector(const Use& use) const {
    ForEach<Shape::kVectorCount>(Count(), use);
  }
  template <class Use>
  static HWY_INLINE void ForEachPart(const Use& use) {
    ForEach<kIndexParts>(kIndexParts, use);
  }

  HWY_INLINE T* IndexPart(int part) const { return s_.right.index + part * s_.stride; }

  static HWY_INLINE Lanes<T> IndicesOf(int part, int v) {
    const Tag<T> d;
    const int first = v * kLanes<T>;
    return part == 0 ? NumbersFrom(d, static_cast<T>(first))
                     : hn::Set(d, static_cast<T>(first >> 8));
  }

  static HWY_INLINE T LeavingLane(const Lanes<T>* vectors, int count) {
    return kForward ? hn::ExtractLane(vectors[count - 1], static_cast<std::size_t>(kLanes<T> - 1))
                    : hn::GetLane(vectors[0]);
  }

  HWY_INLINE std::uint16_t LeavingWinner() const {
    if (LeavingLane(best_, Count()) == kNoOffer) return WinnerMap::kNone;
    unsigned index = LeavingLane(index_[0], Count());
    if constexpr (kIndexParts == 2) index |= unsigned{LeavingLane(index_[1], Count())} << 8;
    return static_cast<std::uint16_t>(index);
  }

  HWY_INLINE void Shift(Lanes<T> enters, Lanes<T>* vectors) const {
    const int last = Count() - 1;
    ForEachVector([&](int i) STEREO_SGMP_INLINE_ATTR {
      if constexpr (kForward) {
        const int v = last - i;
        vectors[v] = FromBelow<T>(v > 0 ? vectors[v - 1] : enters, vectors[v]);
      } else {
        vectors[i] = FromAbove<T>(vectors[i], i < last ? vectors[i + 1] : enters);
      }
    });
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
