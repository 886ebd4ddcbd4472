#include "cost/census_transform.h"

#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "cost/census_transform.cc"
#include <hwy/foreach_target.h>
#include <hwy/highway.h>

HWY_BEFORE_NAMESPACE();
namespace stereo_sgmp {
namespace HWY_NAMESPACE {
namespace hn = hwy::HWY_NAMESPACE;

// Up to 8 comparisons of `width` pixels with their neighbours at `offsets`, one bit each.
void CompareNeighbours(const std::uint8_t* row, const std::ptrdiff_t* offsets, int count, int width,
                       std::uint8_t* bits) {
  const hn::CappedTag<std::uint8_t, FeaturePlanes::kMargin> d;
  const int lanes = static_cast<int>(hn::Lanes(d));
  for (int x = 0; x < width; x += lanes) {
    const auto centre = hn::LoadU(d, row + x);
    auto byte = hn::Zero(d);
    for (int i = 0; i < count; ++i) {
      const auto brighter = hn::Gt(hn::LoadU(d, row + x + offsets[i]), centre);
      // Shifts the new bit in: a true mask is -1.
      byte = hn::Sub(hn::Add(byte, byte), hn::VecFromMask(d, brighter));
    }
    hn::StoreU(byte, d, bits + x);
  }
}

}  // namespace HWY_NAMESPACE
}  // namespace stereo_sgmp
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
#include <algorithm>
#include <array>

namespace stereo_sgmp {

HWY_EXPORT(CompareNeighbours);

void CensusTransformRow(const PaddedGray& image, CensusShape shape, int y, FeaturePlanes* planes) {
  constexpr int kMaxBits = 64;
  std::array<std::ptrdiff_t, kMaxBits> offsets;
  const int sign = image.orientation() == Orientation::kMirrored ? -1 : 1;
  int bits = 0;
  for (int dy = -shape.radius_y; dy <= shape.radius_y; ++dy) {
    for (int dx = -shape.radius_x; dx <= shape.radius_x; ++dx) {
      if (dx == 0 && dy == 0) continue;
      offsets[static_cast<std::size_t>(bits++)] = dy * image.Stride() + sign * dx;
    }
  }
  for (int plane = 0; plane < shape.Bytes(); ++plane) {
    const int first = 8 * plane;
    HWY_DYNAMIC_DISPATCH(CompareNeighbours)
    (image.Row(y), offsets.data() + first, std::min(8, bits - first), image.width(),
     planes->Plane(plane, y));
  }
}

}  // namespace stereo_sgmp
#endif  // HWY_ONCE
