// Lane operations of the aggregation that Highway does not have, for every SIMD target.
#if defined(STEREO_SGMP_AGGREGATION_LANES_INL_H_) == defined(HWY_TARGET_TOGGLE)
#ifdef STEREO_SGMP_AGGREGATION_LANES_INL_H_
#undef STEREO_SGMP_AGGREGATION_LANES_INL_H_
#else
#define STEREO_SGMP_AGGREGATION_LANES_INL_H_
#endif

#include <hwy/highway.h>

#include <cstddef>
#include <cstdint>
#include <utility>

// Of lambdas: what is in vectors has to stay in registers from caller to callee.
#ifndef STEREO_SGMP_INLINE_ATTR
#define STEREO_SGMP_INLINE_ATTR HWY_ATTR __attribute__((always_inline))
#endif

HWY_BEFORE_NAMESPACE();
namespace stereo_sgmp {
namespace HWY_NAMESPACE {
namespace hn = hwy::HWY_NAMESPACE;

template <class T>
using Tag = hn::ScalableTag<T>;
template <class T>
using Lanes = hn::Vec<Tag<T>>;
using Tag16 = Tag<std::uint16_t>;
using Lanes16 = Lanes<std::uint16_t>;

template <class T>
inline constexpr int kLanes = static_cast<int>(hn::MaxLanes(Tag<T>()));

template <class Use, int... kEach>
HWY_INLINE void UseEach(const Use& use, std::integer_sequence<int, kEach...> /*each*/) {
  (use(kEach), ...);
}

// Calls use(i) for each i in [0, count). With kCount known, other than 0, without a loop: an array
// of vectors that a loop goes through may stay in memory, where each waits for its store.
template <int kCount, class Use>
HWY_INLINE void ForEach(int count, const Use& use) {
  if constexpr (kCount > 0) {
    UseEach(use, std::make_integer_sequence<int, kCount>());
  } else {
    for (int i = 0; i < count; ++i) use(i);
  }
}

#if HWY_TARGET != HWY_SCALAR

// Smallest of 128 bits, in the lowest lane; the others are unspecified.
template <class D>
HWY_INLINE hn::Vec<D> SmallestOfBlock(D d, hn::Vec<D> v) {
  if constexpr (sizeof(hn::TFromD<D>) == 1) {
    // The smaller byte of each pair, as a 16-bit number.
    const hn::Repartition<std::uint16_t, D> d16;
    const auto upper = hn::BitCast(d, hn::ShiftRight<8>(hn::BitCast(d16, v)));
    return hn::BitCast(d, SmallestOfBlock(d16, hn::BitCast(d16, hn::Min(v, upper))));
  } else {
#if HWY_ARCH_X86 && HWY_TARGET <= HWY_SSE4
    return hn::Vec<D>{_mm_minpos_epu16(v.raw)};
#else
    return hn::MinOfLanes(d, v);
#endif
  }
}

// The smallest of corresponding lanes of all blocks of 128 bits.
template <class D>
HWY_INLINE auto SmallestOfBlocks(D /*d*/, hn::Vec<D> v) {
  if constexpr (hn::MaxLanes(D()) * sizeof(hn::TFromD<D>) > 16) {
    const hn::Half<D> half;
    return SmallestOfBlocks(half, hn::Min(hn::LowerHalf(half, v), hn::UpperHalf(half, v)));
  } else {
    return v;
  }
}

// Smallest lane, in the lowest one.
template <class D>
HWY_INLINE auto SmallestInFirst(D d, hn::Vec<D> v) {
  const hn::CappedTag<hn::TFromD<D>, 16 / sizeof(hn::TFromD<D>)> block;
  return SmallestOfBlock(block, SmallestOfBlocks(d, v));
}

// The smaller ones of neighbours: those of `a` in even lanes of each block, of `b` in odd ones.
template <class D>
HWY_INLINE hn::Vec<D> SmallerNeighbours(D d, hn::Vec<D> a, hn::Vec<D> b) {
  return hn::Min(hn::InterleaveLower(d, a, b), hn::InterleaveUpper(d, a, b));
}

#endif  // HWY_TARGET != HWY_SCALAR

// Stores the smallest lane of each of kCount vectors; vector i is get(i). They halve together, so
// that each takes two shuffles in place of five.
template <class T, int kCount, class Get>
HWY_INLINE void StoreSmallest(const Get& get, T* smallest) {
#if HWY_TARGET == HWY_SCALAR
  for (int i = 0; i < kCount; ++i) smallest[i] = hn::GetLane(get(i));
#else
  const Tag<T> d;
  constexpr int kAtOnce = 16 / static_cast<int>(sizeof(T));  // as many as a block has lanes
  static_assert(kCount % kAtOnce == 0, "blocks are filled");
  for (int first = 0; first < kCount; first += kAtOnce) {
    Lanes<T> v[kAtOnce / 2];
    for (int i = 0; i < kAtOnce / 2; ++i) {
      v[i] = SmallerNeighbours(d, get(first + i), get(first + i + kAtOnce / 2));
    }
    for (int n = kAtOnce / 4; n > 0; n /= 2) {
      for (int i = 0; i < n; ++i) v[i] = SmallerNeighbours(d, v[i], v[i + n]);
    }
    const hn::CappedTag<T, kAtOnce> block;
    hn::Store(SmallestOfBlocks(d, v[0]), block, smallest + first);
  }
#endif
}

// Smallest lane, in all lanes. What a vector has in a vector, it keeps there: the next pixel waits.
template <class D>
HWY_INLINE hn::Vec<D> SmallestOfLanes(D d, hn::Vec<D> v) {
#if HWY_TARGET == HWY_SCALAR
  (void)d;
  return v;
#elif HWY_TARGET <= HWY_AVX3
  const auto first = SmallestInFirst(d, v);
  if constexpr (sizeof(hn::TFromD<D>) == 1)
    return hn::Vec<D>{_mm512_broadcastb_epi8(first.raw)};
  else
    return hn::Vec<D>{_mm512_broadcastw_epi16(first.raw)};
#elif HWY_TARGET == HWY_AVX2
  const auto first = SmallestInFirst(d, v);
  if constexpr (sizeof(hn::TFromD<D>) == 1)
    return hn::Vec<D>{_mm256_broadcastb_epi8(first.raw)};
  else
    return hn::Vec<D>{_mm256_broadcastw_epi16(first.raw)};
#else
  return hn::Set(d, hn::GetLane(SmallestInFirst(d, v)));
#endif
}

#if HWY_TARGET <= HWY_AVX3_DL

// Bytes from lane `first` of `low`, and from `high` on: one shuffle in place of two.
HWY_INLINE Lanes<std::uint8_t> ConcatFrom(std::uint8_t first, Lanes<std::uint8_t> low,
                                          Lanes<std::uint8_t> high) {
  const Lanes<std::uint8_t> lanes = hn::Iota(Tag<std::uint8_t>(), first);
  return Lanes<std::uint8_t>{_mm512_permutex2var_epi8(low.raw, lanes.raw, high.raw)};
}

#endif  // HWY_TARGET <= HWY_AVX3_DL

// Lane i becomes lane i + 1; the lowest comes from the highest of `below`.
template <class T>
HWY_INLINE Lanes<T> FromBelow(Lanes<T> below, Lanes<T> v) {
#if HWY_TARGET == HWY_SCALAR
  (void)v;
  return below;
#else
#if HWY_TARGET <= HWY_AVX3_DL
  if constexpr (sizeof(T) == 1) return ConcatFrom(kLanes<T> - 1, below, v);
#endif
  const Tag<T> d;
#if HWY_TARGET <= HWY_AVX3
  const Lanes<T> blocks{_mm512_alignr_epi64(v.raw, below.raw, 6)};
#elif HWY_TARGET == HWY_AVX2
  const Lanes<T> blocks = hn::ConcatLowerUpper(d, v, below);
#else
  const Lanes<T> blocks = below;
#endif
  return hn::CombineShiftRightBytes<16 - sizeof(T)>(d, v, blocks);
#endif
}

// Lane i becomes lane i - 1; the highest comes from the lowest of `above`.
template <class T>
HWY_INLINE Lanes<T> FromAbove(Lanes<T> v, Lanes<T> above) {
#if HWY_TARGET == HWY_SCALAR
  (void)v;
  return above;
#else
#if HWY_TARGET <= HWY_AVX3_DL
  if constexpr (sizeof(T) == 1) return ConcatFrom(1, v, above);
#endif
  const Tag<T> d;
#if HWY_TARGET <= HWY_AVX3
  const Lanes<T> blocks{_mm512_alignr_epi64(above.raw, v.raw, 2)};
#elif HWY_TARGET == HWY_AVX2
  const Lanes<T> blocks = hn::ConcatLowerUpper(d, above, v);
#else
  const Lanes<T> blocks = above;
#endif
  return hn::CombineShiftRightBytes<sizeof(T)>(d, blocks, v);
#endif
}

// All bits of the lanes from `count` on; none of those before.
template <class T>
HWY_INLINE Lanes<T> TailBits(int count) {
  const Tag<T> d;
  return hn::VecFromMask(d, hn::Not(hn::FirstN(d, static_cast<std::size_t>(count))));
}

// Adds to `sum` what the costs of two paths exceed their least by. Bytes are summed in steps of
// two: two paths by their mean, rounded up, and what does not fit stays the largest number.
template <class T>
HWY_INLINE Lanes<T> AddExcess(Lanes<T> sum, Lanes<T> one, Lanes<T> other) {
  if constexpr (sizeof(T) == 1) {
    return hn::SaturatedAdd(sum, hn::AverageRound(one, other));
  } else {
    return hn::Add(sum, hn::Add(one, other));
  }
}

}  // namespace HWY_NAMESPACE
}  // namespace stereo_sgmp
HWY_AFTER_NAMESPACE();

#endif  // per-target include guard
