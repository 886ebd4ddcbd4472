// Hamming distance of census bits, for every SIMD target.
#if defined(STEREO_SGMP_COST_HAMMING_INL_H_) == defined(HWY_TARGET_TOGGLE)
#ifdef STEREO_SGMP_COST_HAMMING_INL_H_
#undef STEREO_SGMP_COST_HAMMING_INL_H_
#else
#define STEREO_SGMP_COST_HAMMING_INL_H_
#endif

#include <cstddef>
#include <cstdint>

#include <hwy/highway.h>

HWY_BEFORE_NAMESPACE();
namespace stereo_sgmp {
namespace HWY_NAMESPACE {

// Most of x86 counts the bits of a byte by looking up its halves, six operations in all. There it
// takes fewer to add three bytes bit by bit first, and to count the bits of the two that this
// gives.
#if HWY_ARCH_X86 && HWY_TARGET != HWY_SCALAR && HWY_TARGET > HWY_AVX3_DL
inline constexpr bool kAddsBitsFirst = true;
#else
inline constexpr bool kAddsBitsFirst = false;
#endif

// The sum of three bytes bit by bit: ones + 2 twos.
template <class V>
struct BitSum {
  HWY_INLINE BitSum(V a, V b, V c) {
    namespace hn = hwy::HWY_NAMESPACE;
    const V either = hn::Xor(a, b);
    ones = hn::Xor(either, c);
    twos = hn::Or(hn::And(a, b), hn::And(either, c));
  }

  V ones;
  V twos;
};

// Number of the bits that are set in corresponding bytes of all vectors.
template <int kCount, class V>
HWY_INLINE V CountBits(const V (&bits)[kCount]) {
  namespace hn = hwy::HWY_NAMESPACE;
  constexpr int kTriples = kCount / 3;
  constexpr int kRest = kCount - 3 * kTriples;
  if constexpr (kAddsBitsFirst && kTriples > 0) {
    V ones[kTriples + kRest];
    V twos[kTriples];
    for (int i = 0; i < kTriples; ++i) {
      const BitSum<V> sum(bits[3 * i], bits[3 * i + 1], bits[3 * i + 2]);
      ones[i] = sum.ones;
      twos[i] = sum.twos;
    }
    for (int i = 0; i < kRest; ++i) ones[kTriples + i] = bits[3 * kTriples + i];
    const V pairs = CountBits(twos);
    return hn::Add(CountBits(ones), hn::Add(pairs, pairs));
  } else {
    V sum = hn::PopulationCount(bits[0]);
    for (int i = 1; i < kCount; ++i) sum = hn::Add(sum, hn::PopulationCount(bits[i]));
    return sum;
  }
}

// Distance of one left pixel, which has planes[i] in all lanes of vector i, to the right pixels at
// `right` and behind: plane i of them stands at right + i * distance.
template <int kPlanes, class D>
HWY_INLINE hwy::HWY_NAMESPACE::Vec<D> HammingDistance(
    D d, const hwy::HWY_NAMESPACE::Vec<D> (&planes)[kPlanes], const std::uint8_t* right,
    std::ptrdiff_t distance) {
  namespace hn = hwy::HWY_NAMESPACE;
  hn::Vec<D> different[kPlanes];
  for (int i = 0; i < kPlanes; ++i) {
    different[i] = hn::Xor(planes[i], hn::LoadU(d, right + i * distance));
  }
  return CountBits(different);
}

}  // namespace HWY_NAMESPACE
}  // namespace stereo_sgmp
HWY_AFTER_NAMESPACE();

#endif  // STEREO_SGMP_COST_HAMMING_INL_H_
