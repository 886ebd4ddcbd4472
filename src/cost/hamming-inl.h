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

// Distance of one left pixel, which has planes[i] in all lanes of vector i, to the right pixels at
// `right` and behind: plane i of them stands at right + i * distance.
template <int kPlanes, class D>
HWY_INLINE hwy::HWY_NAMESPACE::Vec<D> HammingDistance(
    D d, const hwy::HWY_NAMESPACE::Vec<D> (&planes)[kPlanes], const std::uint8_t* right,
    std::ptrdiff_t distance) {
  namespace hn = hwy::HWY_NAMESPACE;
  auto sum = hn::PopulationCount(hn::Xor(planes[0], hn::LoadU(d, right)));
  for (int i = 1; i < kPlanes; ++i) {
    const auto bits = hn::Xor(planes[i], hn::LoadU(d, right + i * distance));
    sum = hn::Add(sum, hn::PopulationCount(bits));
  }
  return sum;
}

}  // namespace HWY_NAMESPACE
}  // namespace stereo_sgmp
HWY_AFTER_NAMESPACE();

#endif  // STEREO_SGMP_COST_HAMMING_INL_H_
