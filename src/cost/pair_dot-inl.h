// Products of pairs of 16-bit numbers, for every SIMD target.
#if defined(STEREO_SGMP_COST_PAIR_DOT_INL_H_) == defined(HWY_TARGET_TOGGLE)
#ifdef STEREO_SGMP_COST_PAIR_DOT_INL_H_
#undef STEREO_SGMP_COST_PAIR_DOT_INL_H_
#else
#define STEREO_SGMP_COST_PAIR_DOT_INL_H_
#endif

#include <cstdint>

#include <hwy/highway.h>

HWY_BEFORE_NAMESPACE();
namespace stereo_sgmp {
namespace HWY_NAMESPACE {

// sum + a_low b_low + a_high b_high of pairs of signed 16-bit numbers in each 32 bits.
template <class D32, class V32 = hwy::HWY_NAMESPACE::Vec<D32>>
HWY_INLINE V32 PairDot([[maybe_unused]] D32 d32, V32 a, V32 b, V32 sum) {
  namespace hn = hwy::HWY_NAMESPACE;
#if HWY_TARGET == HWY_SCALAR
  const V32 low =
      hn::Mul(hn::ShiftRight<16>(hn::ShiftLeft<16>(a)), hn::ShiftRight<16>(hn::ShiftLeft<16>(b)));
  const V32 high = hn::Mul(hn::ShiftRight<16>(a), hn::ShiftRight<16>(b));
  return hn::Add(sum, hn::Add(low, high));
#else
  const hn::Repartition<std::int16_t, D32> d16;
  // `sum` stays out of the accumulators: which lanes they hold depends on the target.
  V32 odd = hn::Zero(d32);
  const V32 even = hn::ReorderWidenMulAccumulate(d32, hn::BitCast(d16, a), hn::BitCast(d16, b),
                                                 hn::Zero(d32), odd);
  return hn::Add(sum, hn::RearrangeToOddPlusEven(even, odd));
#endif
}

}  // namespace HWY_NAMESPACE
}  // namespace stereo_sgmp
HWY_AFTER_NAMESPACE();

#endif  // STEREO_SGMP_COST_PAIR_DOT_INL_H_
