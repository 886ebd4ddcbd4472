// S(p, d) of the pixels of a stretch, complete.
#if defined(STEREO_SGMP_AGGREGATION_STRETCH_SUMS_INL_H_) == defined(HWY_TARGET_TOGGLE)
#ifdef STEREO_SGMP_AGGREGATION_STRETCH_SUMS_INL_H_
#undef STEREO_SGMP_AGGREGATION_STRETCH_SUMS_INL_H_
#else
#define STEREO_SGMP_AGGREGATION_STRETCH_SUMS_INL_H_
#endif

#include <hwy/highway.h>

#include <algorithm>
#include <cstddef>
#include <cstdint>

#include "aggregation/lanes-inl.h"
#include "aggregation/sweep_kernel.h"

HWY_BEFORE_NAMESPACE();
namespace stereo_sgmp {
namespace HWY_NAMESPACE {
namespace hn = hwy::HWY_NAMESPACE;

// S of a pixel: it is stored from the last pixel of the image to the first, so that a backward
// sweep that has to wait for it reads on and on. `offset` counts from the first pixel.
template <class T>
HWY_INLINE T* StoredSum(const SweepStretch<T>& s, std::ptrdiff_t offset) {
  return s.sum - offset * s.stride;
}

// Takes the second halves of S of the pixels of a stretch, and adds the first ones to all of them
// at once: what one pixel waits for, the others need not. Pixels have the places [0, count()), in
// the order of the image.
template <class T, class Shape>
class StretchSums {
 public:
  static constexpr int kPixels = SweepStretch<T>::kMaxPixels;

  StretchSums(const SweepStretch<T>& s, const Shape& shape)
      : shape_(shape),
        count_(s.Count()),
        start_(s.IsForward() ? 0 : count_ - 1),
        stride_(s.stride),
        first_column_(s.x_first - start_),
        excess_(s.excess),
        first_half_(StoredSum(s, -start_)),
        minima_of_first_(s.minimum_sum - start_) {}

  // The second half of the pixel at `offset` from the first, and what its paths cost at least.
  HWY_INLINE void Take(std::ptrdiff_t offset, const Lanes<T>* half, int path_minima) {
    const std::ptrdiff_t place = start_ + offset;
    for (int v = 0; v < shape_.Count(); ++v) {
      hn::Store(half[v], Tag<T>(), Row(place) + v * kLanes<T>);
    }
    path_minima_[place] = path_minima;
  }

  // What S exceeds the base of its pixel by, at most the largest number, which is also what the
  // disparities beyond the last one have.
  HWY_INLINE void Complete() {
    const Tag<T> d;
    HWY_ALIGN T least_of_first[kPixels];
    HWY_ALIGN T least_of_last[kPixels];
    StoreSmallest<T, kPixels>(
        [&](int place) STEREO_SGMP_INLINE_ATTR {
          const T* half = FirstHalf(std::min(place, count_ - 1));
          return LeastOfVectors(
              [&](int v) STEREO_SGMP_INLINE_ATTR { return hn::Load(d, half + v * kLanes<T>); });
        },
        least_of_first);
    StoreLeast(least_of_last);
    for (int place = 0; place < count_; ++place) {
      AddFirstHalf(place, hn::Set(d, least_of_first[place]), hn::Set(d, least_of_last[place]));
    }
    for (int i = 0; i < count_; ++i) {
      path_minima_[i] = (path_minima_[i] + minima_of_first_[i]) / kSumStep<T>;
      base_[i] = path_minima_[i] + least_of_first[i] + least_of_last[i];
    }
  }

  // The least of each place.
  HWY_INLINE void StoreLeast(T* least) const {
    StoreLeastOf([](int, int, Lanes<T> excess) STEREO_SGMP_INLINE_ATTR { return excess; }, least);
  }

  // The least of each place of what change(place, vector, excess) makes of it.
  template <class Change>
  HWY_INLINE void StoreLeastOf(const Change& change, T* least) const {
    StoreSmallest<T, kPixels>(
        [&](int place) STEREO_SGMP_INLINE_ATTR {
          return LeastOfVectors(
              [&](int v) STEREO_SGMP_INLINE_ATTR { return change(place, v, Vector(place, v)); });
        },
        least);
  }

  HWY_INLINE Lanes<T> Vector(int place, int v) const {
    return hn::Load(Tag<T>(), Row(place) + v * kLanes<T>);
  }

  HWY_INLINE T* Row(std::ptrdiff_t place) const { return excess_ + place * stride_; }

  int count() const { return count_; }
  // Where the sweep enters the stretch.
  int start() const { return start_; }
  // The image x of the first place.
  int first_column() const { return first_column_; }

  // Of each place, in steps of kSumStep: the sum of what the paths of both sweeps cost at least,
  // and the base that the excess counts from.
  const int* path_minima() const { return path_minima_; }
  const int* base() const { return base_; }

 private:
  HWY_INLINE const T* FirstHalf(std::ptrdiff_t place) const {
    return first_half_ - place * stride_;
  }

  template <class Get>
  HWY_INLINE Lanes<T> LeastOfVectors(const Get& get) const {
    const int last = shape_.Count() - 1;
    Lanes<T> least = shape_.WithTail(get(last));
    for (int v = 0; v < last; ++v) least = hn::Min(least, get(v));
    return least;
  }

  HWY_INLINE void AddFirstHalf(int place, Lanes<T> least_of_first, Lanes<T> least_of_last) const {
    const Tag<T> d;
    const int last = shape_.Count() - 1;
    for (int v = 0; v <= last; ++v) {
      const auto first = hn::Load(d, FirstHalf(place) + v * kLanes<T>);
      const auto sum = hn::SaturatedAdd(hn::Sub(first, least_of_first),
                                        hn::Sub(Vector(place, v), least_of_last));
      hn::Store(v == last ? shape_.WithTail(sum) : sum, d, Row(place) + v * kLanes<T>);
    }
  }

  const Shape& shape_;
  // Kept here, since what is stored could change the stretch for all that the compiler knows.
  const int count_;
  const int start_;
  const std::ptrdiff_t stride_;
  const int first_column_;
  T* const excess_;
  const T* const first_half_;
  const std::uint16_t* const minima_of_first_;
  int path_minima_[kPixels] = {};
  int base_[kPixels] = {};
};

}  // namespace HWY_NAMESPACE
}  // namespace stereo_sgmp
HWY_AFTER_NAMESPACE();

#endif  // per-target include guard
