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
    for (int place = sums_.begin(); place < kPixels; ++place) winner_[place] = FirstLeast(place);
    StoreSecond();
    OfferToRight();
    WriteLeast();
    WriteNeighbours();
  }

 private:
  static constexpr T kMost = std::numeric_limits<T>::max();
  static constexpr int kPixels = StretchSums<T, Shape>::kPixels;

  // Smallest index with the least excess.
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

  HWY_INLINE void OfferToRight() const {
    RightWindow<T, Shape> right(s_, shape_);
    std::uint16_t winners[kPixels];
    for (int place = kPixels - 1; place >= sums_.begin(); --place) {
      const auto base = static_cast<T>(std::min<int>(sums_.base()[place], kMost));
      const Lanes<T> bases = hn::Set(Tag<T>(), base);
      for (int v = 0; v < shape_.Count(); ++v) {
        right.Offer(v, OfferOf<T>(sums_.Vector(place, v), bases));
      }
      winners[place] = right.Leave();
    }
    // What is done with matches disparity index 0.
    const int offset = s_.right.min_disparity;
    const int begin = std::max(sums_.FirstColumn() - offset, 0);
    const int end = std::min(s_.x_first + 1 - offset, s_.width);
    if (begin < end) {
      const int place = kPixels - 1 - (s_.x_first - offset - begin);
      std::copy_n(winners + place, end - begin, s_.right.winner + begin);
    }
    right.Finish(sums_.FirstColumn());
  }

  HWY_INLINE void WriteLeast() const {
    const int unit = s_.unit * kSumStep<T>;
    const int disparities = s_.disparities;
    std::uint16_t winner[kPixels];
    std::uint16_t cost[kPixels];
    std::uint16_t uncertainty[kPixels];
    std::uint16_t second[kPixels];
    for (int i = 0; i < kPixels; ++i) {
      const int least = sums_.base()[i] + least_[i];
      const int next = (sums_.base()[i] + second_[i]) * unit;
      const bool has_second = winner_[i] > 1 || winner_[i] + 2 < disparities;
      winner[i] = static_cast<std::uint16_t>(winner_[i]);
      cost[i] = static_cast<std::uint16_t>(least * unit);
      uncertainty[i] = static_cast<std::uint16_t>((least - sums_.path_minima()[i]) * unit);
      second[i] = static_cast<std::uint16_t>(has_second ? next : WinnerMap::kNone);
    }
    Write(winner, s_.winners.winner);
    Write(cost, s_.winners.cost);
    Write(uncertainty, s_.winners.uncertainty);
    Write(second, s_.winners.second);
  }

  HWY_INLINE void WriteNeighbours() const {
    const int unit = s_.unit * kSumStep<T>;
    const int last = s_.disparities - 1;
    int excess_below[kPixels];
    int excess_above[kPixels];
    for (int i = 0; i < kPixels; ++i) {
      const T* excess = sums_.Row(i);
      excess_below[i] = excess[std::max(winner_[i] - 1, 0)];
      excess_above[i] = excess[std::min(winner_[i] + 1, last)];
    }
    std::uint16_t below[kPixels];
    std::uint16_t above[kPixels];
    for (int i = 0; i < kPixels; ++i) {
      const int sum_below = (sums_.base()[i] + excess_below[i]) * unit;
      const int sum_above = (sums_.base()[i] + excess_above[i]) * unit;
      below[i] = static_cast<std::uint16_t>(winner_[i] > 0 ? sum_below : WinnerMap::kNone);
      above[i] = static_cast<std::uint16_t>(winner_[i] < last ? sum_above : WinnerMap::kNone);
    }
    Write(below, s_.winners.cost_below);
    Write(above, s_.winners.cost_above);
  }

  // Most stretches have all pixels: their number is known then, and they are written at once.
  HWY_INLINE void Write(const std::uint16_t* values, std::uint16_t* row) const {
    std::uint16_t* out = row + sums_.FirstColumn();
    if (HWY_LIKELY(sums_.begin() == 0)) {
      std::copy_n(values, kPixels, out);
    } else {
      std::copy(values + sums_.begin(), values + kPixels, out);
    }
  }

  const SweepStretch<T>& s_;
  const Shape& shape_;
  const StretchSums<T, Shape>& sums_;
  int winner_[kPixels] = {};  // disparity indices, by place
  HWY_ALIGN T least_[kPixels];
  HWY_ALIGN T second_[kPixels];
};

}  // namespace HWY_NAMESPACE
}  // namespace stereo_sgmp
HWY_AFTER_NAMESPACE();

#endif  // per-target include guard
