// Consecutive numbers in lanes, for every SIMD target.
#if defined(STEREO_SGMP_COMMON_NUMBERS_INL_H_) == defined(HWY_TARGET_TOGGLE)
#ifdef STEREO_SGMP_COMMON_NUMBERS_INL_H_
#undef STEREO_SGMP_COMMON_NUMBERS_INL_H_
#else
#define STEREO_SGMP_COMMON_NUMBERS_INL_H_
#endif

#include <hwy/highway.h>

HWY_BEFORE_NAMESPACE();
namespace stereo_sgmp {
namespace HWY_NAMESPACE {

// The numbers from `first` on. Highway's Iota stores those that are not known at compile time one
// by one, and what reads the vector has to wait for all of them.
template <class D>
HWY_INLINE hwy::HWY_NAMESPACE::Vec<D> NumbersFrom(D d, hwy::HWY_NAMESPACE::TFromD<D> first) {
  namespace hn = hwy::HWY_NAMESPACE;
  return hn::Add(hn::Iota(d, hn::TFromD<D>{0}), hn::Set(d, first));
}

}  // namespace HWY_NAMESPACE
}  // namespace stereo_sgmp
HWY_AFTER_NAMESPACE();

#endif  // per-target include guard
