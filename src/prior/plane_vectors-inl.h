// Planes along vectors of pixels, for every SIMD target.
#if defined(STEREO_SGMP_PRIOR_PLANE_VECTORS_INL_H_) == defined(HWY_TARGET_TOGGLE)
#ifdef STEREO_SGMP_PRIOR_PLANE_VECTORS_INL_H_
#undef STEREO_SGMP_PRIOR_PLANE_VECTORS_INL_H_
#else
#define STEREO_SGMP_PRIOR_PLANE_VECTORS_INL_H_
#endif

#include <cstddef>
#include <cstdint>

#include <hwy/highway.h>

#include "prior/orientation_prior.h"
#include "prior/plane_jump_kernel.h"

HWY_BEFORE_NAMESPACE();
namespace stereo_sgmp {
namespace HWY_NAMESPACE {
namespace hn = hwy::HWY_NAMESPACE;

// No longer than what the entries of a JumpRow have room for.
using Unsigned = hn::CappedTag<std::uint32_t, JumpEntries::kVector>;
using Signed = hn::RebindToSigned<Unsigned>;
using VU = hn::Vec<Unsigned>;
using VS = hn::Vec<Signed>;

// The fraction of S + 1/2 after `steps` pixels.
HWY_INLINE VU FractionsAt(const PlaneRun& plane, VU steps) {
  const Unsigned d;
  return hn::Add(hn::Set(d, plane.fraction), hn::Mul(steps, hn::Set(d, plane.slope)));
}

// Bit by bit.
template <class D>
HWY_INLINE std::uint64_t BitsOf([[maybe_unused]] D d, hn::Mask<D> mask) {
#if HWY_TARGET <= HWY_AVX3
  return mask.raw;  // has the bits as they are; storing them takes them apart
#else
  std::uint8_t bits[8] = {};
  const std::size_t bytes = hn::StoreMaskBits(d, mask, bits);
  std::uint64_t all = 0;
  for (std::size_t b = 0; b < bytes; ++b) all |= std::uint64_t{bits[b]} << (8 * b);
  return all;
#endif
}

// S^ after `steps` pixels, fewer than 2^16.
HWY_INLINE VS ValuesAt(const PlaneRun& plane, VU steps) {
  const Unsigned d;
  const Signed ds;
  // The whole part of steps * slope, whose halves of 16 bits are multiplied one by one.
  const VU low = hn::ShiftRight<16>(hn::Mul(steps, hn::Set(d, plane.slope & 0xFFFFU)));
  const VU high = hn::Mul(steps, hn::Set(d, plane.slope >> 16));
  const VU product = hn::ShiftRight<16>(hn::Add(high, low));
  const VU whole =
      hn::Add(hn::Set(d, static_cast<std::uint32_t>(plane.whole)),
              hn::Mul(steps, hn::Set(d, static_cast<std::uint32_t>(plane.slope_whole))));
  const auto carries = hn::Lt(FractionsAt(plane, steps), hn::Set(d, plane.fraction));
  const VU carry = hn::IfThenElse(carries, hn::Set(d, 1U), hn::Zero(d));
  return hn::BitCast(ds, hn::Add(hn::Add(whole, product), carry));
}

}  // namespace HWY_NAMESPACE
}  // namespace stereo_sgmp
HWY_AFTER_NAMESPACE();

#endif  // per-target include guard
