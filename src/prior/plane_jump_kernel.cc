#include "prior/plane_jump_kernel.h"

#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "prior/plane_jump_kernel.cc"
#include <hwy/foreach_target.h>

#include <hwy/highway.h>

#include <cstddef>

HWY_BEFORE_NAMESPACE();
namespace stereo_sgmp {
namespace HWY_NAMESPACE {
namespace hn = hwy::HWY_NAMESPACE;

using Unsigned = hn::ScalableTag<std::uint32_t>;
using Signed = hn::RebindToSigned<Unsigned>;
using Short = hn::Rebind<std::int16_t, Signed>;

// Jumps of a plane at the pixels from i on, one for each of `steps`.
HWY_INLINE hn::Vec<Signed> JumpsAt(const PlaneRun& plane, std::uint32_t i,
                                   hn::Vec<Unsigned> steps) {
  const Unsigned d;
  const Signed ds;
  const auto at_p = hn::Add(hn::Set(d, plane.fraction + i * plane.slope),
                            hn::Mul(steps, hn::Set(d, plane.slope)));
  const auto at_q = hn::Add(at_p, hn::Set(d, plane.step));
  return hn::IfThenElse(hn::RebindMask(ds, hn::Lt(at_q, at_p)), hn::Set(ds, plane.jump_with_carry),
                        hn::Set(ds, plane.jump));
}

// One bit for each lane that isn't zero, the first lane's at `place`.
HWY_INLINE std::uint64_t BitsOf(hn::Vec<Signed> v, int place) {
  const Signed d;
  std::uint8_t bits[8] = {};
  const std::size_t bytes = hn::StoreMaskBits(d, hn::Ne(v, hn::Zero(d)), bits);
  std::uint64_t all = 0;
  for (std::size_t b = 0; b < bytes; ++b) all |= std::uint64_t{bits[b]} << (8 * b);
  return all << place;
}

std::uint64_t Jumps(const PlaneRun* HWY_RESTRICT planes, int plane_count, int count,
                    std::int16_t* HWY_RESTRICT jumps, std::uint64_t* HWY_RESTRICT moves) {
  const Unsigned d;
  const Signed ds;
  const Short d16;
  const int lanes = static_cast<int>(hn::Lanes(d));
  const auto steps = hn::Iota(d, 0U);
  const std::uint64_t all =
      count < kMaxPlaneRun ? (std::uint64_t{1} << count) - 1 : ~std::uint64_t{0};
  std::uint64_t differ = 0;
  for (int k = 0; k < plane_count; ++k) moves[k] = 0;
  for (int i = 0; i < count; i += lanes) {
    const auto first = JumpsAt(planes[0], static_cast<std::uint32_t>(i), steps);
    auto difference = hn::Zero(ds);
    for (int k = 0; k < plane_count; ++k) {
      const auto jump = JumpsAt(planes[k], static_cast<std::uint32_t>(i), steps);
      hn::StoreU(hn::DemoteTo(d16, jump), d16, jumps + k * kMaxPlaneRun + i);
      moves[k] |= BitsOf(jump, i) & all;
      difference = hn::Or(difference, hn::Xor(jump, first));
    }
    differ |= BitsOf(difference, i);
  }
  return differ & all;
}

}  // namespace HWY_NAMESPACE
}  // namespace stereo_sgmp
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace stereo_sgmp {

HWY_EXPORT(Jumps);

std::uint64_t JumpsOfPlanes(const PlaneRun* planes, int plane_count, int count, std::int16_t* jumps,
                            std::uint64_t* moves) {
  return HWY_DYNAMIC_DISPATCH(Jumps)(planes, plane_count, count, jumps, moves);
}

}  // namespace stereo_sgmp
#endif  // HWY_ONCE
