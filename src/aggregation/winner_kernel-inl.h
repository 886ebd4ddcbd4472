// What the last sweep reads off the complete S of a stretch: winners, second best, right image.
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
#include "aggregation/right_window-inl.h"
#include "aggregation/stretch_sums-inl.h"
#include "aggregation/sweep_kernel.h"
#include "common/numbers-inl.h"

HWY_BEFORE_NAMESPACE();
namespace stereo_sgmp {
namespace HWY_NAMESPACE {
namespace hn = hwy::HWY_NAMESPACE;

// Step by step for all pixels, as StretchSums has them: where one has to wait for what it looks up,
// the others go on, and each row of the winner map is written at once.
template <class T, class Shape>
class WinnerReader {
 public:
  WinnerReader(const SweepStretch<T>& s, const Shape& shape, const StretchSums<T, Shape>& sums)
      : s_(s), shape_(shape), sums_(sums) {}

  HWY_INLINE void Read() {
    sums_.StoreLeast(least_);
    StoreWinners();
    LookUpNeighbours();
    StoreSecond();
    s_.IsForward() ? OfferForward() : OfferBackward();
    // What was found pixel by pixel, some steps ago, so that no vector of it waits for the stores
    // of its lanes.
    WriteLeast();
    WriteNeighbours();
    WriteRight();
  }

 private:
  static constexpr T kMost = std::numeric_limits<T>::max();
  static constexpr int kPixels = StretchSums<T, Shape>::kPixels;

  // Whether all disparity indices fit a lane.
  static constexpr bool kIndicesFit = Shape::kMost * kLanes<T> - 1 <= kMost;

  // The smallest indices with the least excess.
  HWY_INLINE void StoreWinners() {
    if constexpr (kIndicesFit) {
      const Tag<T> d;
      HWY_ALIGN T winner[kPixels];
      sums_.StoreLeastOf(
          [&](int place, int v, Lanes<T> excess) STEREO_SGMP_INLINE_ATTR {
            const auto is_least = hn::Eq(excess, hn::Set(d, least_[place]));
            const Lanes<T> indices = NumbersFrom(d, static_cast<T>(v * kLanes<T>));
            return hn::IfThenElse(is_least, indices, hn::Set(d, kMost));
          },
          winner);
      std::copy_n(winner, kPixels, winner_);
    } else {
      for (int place = 0; place < sums_.count(); ++place) winner_[place] = FirstLeast(place);
    }
  }

  // The smallest index of one place, where indices need more than a lane.
  HWY_INLINE int FirstLeast(int place) const {
    const Tag<T> d;
    const Lanes<T> least = hn::Set(d, least_[place]);
    int first = 0;
    for (int v = shape_.Count() - 1; v >= 0; --v) {
      const auto lane = hn::FindFirstTrue(d, hn::Eq(sums_.Vector(place, v), least));
      first = lane >= 0 ? v * kLanes<T> + static_cast<int>(lane) : first;
    }
    return first;
  }

  // The least excess further than one from the winner; kMost if there is none.
  HWY_INLINE void StoreSecond() {
    sums_.StoreLeastOf(
        [&](int place, int v, Lanes<T> excess) STEREO_SGMP_INLINE_ATTR {
          const T* near = NearMasks<T>::Around(winner_[place]);
          return hn::Or(excess, hn::LoadU(Tag<T>(), near + v * kLanes<T>));
        },
        second_);
  }

  HWY_INLINE void OfferForward() {
    RightWindow<T, Shape, true> right(s_, shape_);
    for (int place = 0; place < sums_.count(); ++place) {
      right_winner_[place] = right.Move();
      Offer(place, &right);
    }
    right.Finish(sums_.first_column() + sums_.count() - 1 - s_.right.min_disparity);
  }

  HWY_INLINE void OfferBackward() {
    RightWindow<T, Shape, false> right(s_, shape_);
    for (int place = sums_.count() - 1; place >= 0; --place) {
      Offer(place, &right);
      right_winner_[place] = right.Move();
    }
    right.Finish(sums_.first_column() - 1 - s_.right.min_disparity);
  }

  template <class Window>
  HWY_INLINE void Offer(int place, Window* right) const {
    const auto base = static_cast<T>(std::min<int>(sums_.base()[place], kMost));
    const Lanes<T> bases = hn::Set(Tag<T>(), base);
    ForEach<Shape::kVectorCount>(shape_.Count(), [&](int v) STEREO_SGMP_INLINE_ATTR {
      right->Offer(v, OfferOf<T>(sums_.Vector(place, v), bases));
    });
  }

  // The winners of the right pixels that left the window at each place, as far as the image goes:
  // beyond the last lane, or those that match disparity index 0.
  HWY_INLINE void WriteRight() const {
    const int offset = s_.right.min_disparity + (s_.IsForward() ? shape_.Count() * kLanes<T> : 0);
    const int first = sums_.first_column() - offset;
    const int begin = std::max(first, 0);
    const int end = std::min(first + sums_.count(), s_.width);
    if (begin < end) {
      std::copy_n(right_winner_ + (begin - first), end - begin, s_.right.winner + begin);
    }
  }

  HWY_INLINE void WriteLeast() const {
    const int unit = s_.unit * kSumStep<T>;
    const int last_with_second_above = s_.disparities - 3;
    const int* base = sums_.base();
    const int* path_minima = sums_.path_minima();
    std::uint16_t winner[kPixels];
    std::uint16_t cost[kPixels];
    std::uint16_t uncertainty[kPixels];
    std::uint16_t second[kPixels];
    for (int i = 0; i < kPixels; ++i) {
      const int least = base[i] + least_[i];
      const int next = (base[i] + second_[i]) * unit;
      const bool has_second = (winner_[i] > 1) | (winner_[i] <= last_with_second_above);
      winner[i] = static_cast<std::uint16_t>(winner_[i]);
      cost[i] = static_cast<std::uint16_t>(least * unit);
      uncertainty[i] = static_cast<std::uint16_t>((least - path_minima[i]) * unit);
      second[i] = static_cast<std::uint16_t>(has_second ? next : WinnerMap::kNone);
    }
    Write(winner, s_.winners.winner);
    Write(cost, s_.winners.cost);
    Write(uncertainty, s_.winners.uncertainty);
    Write(second, s_.winners.second);
  }

  HWY_INLINE void LookUpNeighbours() {
    const int last = s_.disparities - 1;
    for (int i = 0; i < kPixels; ++i) {
      const T* excess = sums_.Row(i);
      excess_below_[i] = excess[std::max(winner_[i] - 1, 0)];
      excess_above_[i] = excess[std::min(winner_[i] + 1, last)];
    }
  }

  HWY_INLINE void WriteNeighbours() const {
    const int unit = s_.unit * kSumStep<T>;
    const int last = s_.disparities - 1;
    std::uint16_t below[kPixels];
    std::uint16_t above[kPixels];
    for (int i = 0; i < kPixels; ++i) {
      const int sum_below = (sums_.base()[i] + excess_below_[i]) * unit;
      const int sum_above = (sums_.base()[i] + excess_above_[i]) * unit;
      below[i] = static_cast<std::uint16_t>(winner_[i] > 0 ? sum_below : WinnerMap::kNone);
      above[i] = static_cast<std::uint16_t>(winner_[i] < last ? sum_above : WinnerMap::kNone);
    }
    Write(below, s_.winners.cost_below);
    Write(above, s_.winners.cost_above);
  }

  // Most stretches have all pixels: their number is known then, and they are written at once.
  HWY_INLINE void Write(const std::uint16_t* values, std::uint16_t* row) const {
    std::uint16_t* out = row + sums_.first_column();
    if (HWY_LIKELY(sums_.count() == kPixels)) {
      std::copy_n(values, kPixels, out);
    } else {
      std::copy_n(values, sums_.count(), out);
    }
  }

  const SweepStretch<T>& s_;
  const Shape& shape_;
  const StretchSums<T, Shape>& sums_;
  int winner_[kPixels] = {};             // disparity indices, by place
  std::uint16_t right_winner_[kPixels];  // of the right pixel that left the window there
  int excess_below_[kPixels];
  int excess_above_[kPixels];
  HWY_ALIGN T least_[kPixels];
  HWY_ALIGN T second_[kPixels];
};

}  // namespace HWY_NAMESPACE
}  // namespace stereo_sgmp
HWY_AFTER_NAMESPACE();

#endif  // per-target include guard
