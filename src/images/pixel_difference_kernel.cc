#include "images/pixel_difference_kernel.h"

#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "images/pixel_difference_kernel.cc"
#include <hwy/foreach_target.h>
#include <hwy/highway.h>

HWY_BEFORE_NAMESPACE();
namespace stereo_sgmp {
namespace HWY_NAMESPACE {
namespace hn = hwy::HWY_NAMESPACE;

template <class V>
HWY_INLINE V Difference(V a, V b) {
  return hn::Sub(hn::Max(a, b), hn::Min(a, b));
}

template <int kChannels, class D>
HWY_INLINE hn::Vec<D> LargestDifference(D d, const std::uint8_t* from, const std::uint8_t* to) {
  using V = hn::Vec<D>;
  if constexpr (kChannels == 1) {
    return Difference(hn::LoadU(d, from), hn::LoadU(d, to));
  } else {
    V a0, a1, a2, a3, b0, b1, b2, b3;
    if constexpr (kChannels == 3) {
      hn::LoadInterleaved3(d, from, a0, a1, a2);
      hn::LoadInterleaved3(d, to, b0, b1, b2);
    } else {
      hn::LoadInterleaved4(d, from, a0, a1, a2, a3);
      hn::LoadInterleaved4(d, to, b0, b1, b2, b3);
    }
    return hn::Max(hn::Max(Difference(a0, b0), Difference(a1, b1)), Difference(a2, b2));
  }
}

template <int kChannels, class D>
HWY_INLINE void DifferencesOf(D d, const std::uint8_t* from, const std::uint8_t* to, int count,
                              std::uint8_t base, std::uint8_t* differences) {
  const int lanes = static_cast<int>(hn::Lanes(d));
  for (int x = 0; x < count; x += lanes) {
    // The last vector overlaps the one before.
    const int begin = HWY_MIN(x, count - lanes);
    const auto difference =
        LargestDifference<kChannels>(d, from + kChannels * begin, to + kChannels * begin);
    hn::StoreU(hn::SaturatedAdd(difference, hn::Set(d, base)), d, differences + begin);
  }
}

template <int kChannels>
HWY_INLINE void DifferencesOfRow(const std::uint8_t* from, const std::uint8_t* to, int count,
                                 std::uint8_t base, std::uint8_t* differences) {
  const hn::ScalableTag<std::uint8_t> wide;
  const hn::CappedTag<std::uint8_t, 16> narrow;  // coarse rows are short
  if (count >= static_cast<int>(hn::Lanes(wide))) {
    DifferencesOf<kChannels>(wide, from, to, count, base, differences);
  } else if (count >= static_cast<int>(hn::Lanes(narrow))) {
    DifferencesOf<kChannels>(narrow, from, to, count, base, differences);
  } else {
    DifferencesOf<kChannels>(hn::CappedTag<std::uint8_t, 1>(), from, to, count, base, differences);
  }
}

void DifferencesOnTarget(const std::uint8_t* from, const std::uint8_t* to, int channels, int count,
                         std::uint8_t base, std::uint8_t* differences) {
  if (channels == 1) {
    DifferencesOfRow<1>(from, to, count, base, differences);
  } else if (channels == 3) {
    DifferencesOfRow<3>(from, to, count, base, differences);
  } else {
    DifferencesOfRow<4>(from, to, count, base, differences);
  }
}

}  // namespace HWY_NAMESPACE
}  // namespace stereo_sgmp
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace stereo_sgmp {

HWY_EXPORT(DifferencesOnTarget);

void PixelDifferences(const std::uint8_t* from, const std::uint8_t* to, int channels, int count,
                      std::uint8_t base, std::uint8_t* differences) {
  HWY_DYNAMIC_DISPATCH(DifferencesOnTarget)(from, to, channels, count, base, differences);
}

}  // namespace stereo_sgmp
#endif  // HWY_ONCE
