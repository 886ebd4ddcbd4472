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

#include "aggregation/lanes-inl.h"
#include "aggregation/sweep_kernel.h"

HWY_BEFORE_NAMESPACE();
namespace stereo_sgmp {
namespace HWY_NAMESPACE {
namespace hn = hwy::HWY_NAMESPACE;

inline constexpr std::uint16_t kNoSum = std::numeric_limits<std::uint16_t>::max();

// S of one pixel in the parts of SumLayout: index k stands in part k % kParts.
template <class T>
struct PixelSum {
  static constexpr int kParts = SumLayout<T>::kParts;

  std::uint16_t* first;
  std::ptrdiff_t part_size;
  int vectors;  // of each part

  HWY_INLINE std::uint16_t* Part(int part) const { return first + part * part_size; }
  HWY_INLINE std::uint16_t& At(int k) const {
    const auto index = static_cast<unsigned>(k);
    return Part(static_cast<int>(index % kParts))[index / kParts];
  }
};

// The disparity indices of the lanes of vector v of each part of S.
template <class T>
HWY_INLINE Lanes16 IndicesOf(int part, int v) {
  const Tag16 d;
  constexpr int kParts = SumLayout<T>::kParts;
  const int first = v * kLanes<std::uint16_t> * kParts + part;
  const Lanes16 steps = hn::Mul(hn::Iota(d, 0), hn::Set(d, std::uint16_t{kParts}));
  return hn::Add(steps, hn::Set(d, static_cast<std::uint16_t>(first)));
}

// The least S met so far in each lane, and the smallest index that has it.
class LeastSum {
 public:
  LeastSum() : sum_(hn::Set(Tag16(), kNoSum)), index_(hn::Set(Tag16(), kNoSum)) {}

  // Vectors come with rising indices.
  HWY_INLINE void Offer(Lanes16 sum, Lanes16 index) {
    const auto is_less = hn::Lt(sum, sum_);
    sum_ = hn::Min(sum, sum_);
    index_ = hn::IfThenElse(is_less, index, index_);
  }

  HWY_INLINE std::uint16_t Sum() const { return SmallestLane(Tag16(), sum_); }

  // Smallest index with S = `sum`, which is Sum().
  HWY_INLINE int Index(std::uint16_t sum) const {
    const Tag16 d;
    const auto has_it = hn::Eq(sum_, hn::Set(d, sum));
    return SmallestLane(d, hn::IfThenElse(has_it, index_, hn::Set(d, kNoSum)));
  }

 private:
  Lanes16 sum_;
  Lanes16 index_;
};

// The winner of a left pixel; offers S to the right pixels that it can match, at `position` and
// behind. Sweeping x downwards meets the disparities of a right pixel from large to small, so that
// ties go to the smallest. Lanes without a disparity offer kNoSum, which means that there is no
// offer.
template <class T>
HWY_INLINE LeastSum OfferSum(const PixelSum<T>& s, const RightRow& right, int position) {
  const Tag16 d;
  LeastSum of_left;
  std::ptrdiff_t offsets[PixelSum<T>::kParts];
  for (int part = 0; part < s.kParts; ++part)
    offsets[part] = right.Offset(position + part, s.kParts);
  for (int v = 0; v < s.vectors; ++v) {
    for (int part = 0; part < s.kParts; ++part) {
      const int k = v * kLanes<std::uint16_t>;
      std::uint16_t* best = right.cost + offsets[part] + k;
      std::uint16_t* winner = right.winner + offsets[part] + k;
      const Lanes16 sum = hn::Load(d, s.Part(part) + k);
      const Lanes16 index = IndicesOf<T>(part, v);
      of_left.Offer(sum, index);
      const Lanes16 least = hn::Min(sum, hn::LoadU(d, best));
      const Lanes16 kept = hn::LoadU(d, winner);
      hn::StoreU(least, d, best);
      hn::StoreU(hn::IfThenElse(hn::Eq(least, sum), index, kept), d, winner);
    }
  }
  return of_left;
}

// min_d S.
template <class T>
HWY_INLINE std::uint16_t LeastOf(const PixelSum<T>& s) {
  const Tag16 d;
  Lanes16 least = hn::Set(d, kNoSum);
  for (int part = 0; part < s.kParts; ++part) {
    for (int v = 0; v < s.vectors; ++v) {
      least = hn::Min(least, hn::Load(d, s.Part(part) + v * kLanes<std::uint16_t>));
    }
  }
  return SmallestLane(d, least);
}

// Smallest entry further than one from `winner`; kNoSum if there is none.
template <class T>
HWY_INLINE std::uint16_t SecondBest(const PixelSum<T>& s, int winner) {
  const Tag16 d;
  const Lanes16 two = hn::Set(d, std::uint16_t{2});
  const Lanes16 below = hn::Set(d, static_cast<std::uint16_t>(winner - 1));
  Lanes16 least = hn::Set(d, kNoSum);
  for (int v = 0; v < s.vectors; ++v) {
    for (int part = 0; part < s.kParts; ++part) {
      const Lanes16 sum = hn::Load(d, s.Part(part) + v * kLanes<std::uint16_t>);
      // In 16 bits what lies below `below` wraps to large numbers.
      const auto is_far = hn::Gt(hn::Sub(IndicesOf<T>(part, v), below), two);
      least = hn::Min(least, hn::IfThenElse(is_far, sum, hn::Set(d, kNoSum)));
    }
  }
  return SmallestLane(d, least);
}

}  // namespace HWY_NAMESPACE
}  // namespace stereo_sgmp
HWY_AFTER_NAMESPACE();

#endif  // per-target include guard
