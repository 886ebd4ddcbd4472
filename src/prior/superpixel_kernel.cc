#include "prior/superpixel_kernel.h"

#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "prior/superpixel_kernel.cc"
#include <hwy/foreach_target.h>

#include <hwy/highway.h>

HWY_BEFORE_NAMESPACE();
namespace stereo_sgmp {
namespace HWY_NAMESPACE {
namespace hn = hwy::HWY_NAMESPACE;

// One vector of pixels. Doing a pixel twice changes nothing: only a smaller distance wins.
template <int kChannels, class D>
HWY_INLINE void AssignVector(D d, const float* const* channel, float* nearest,
                             std::int32_t* cluster, const ClusterCentre& centre, float left,
                             float spatial_dy, float spatial_weight, std::int32_t label) {
  const hn::RebindToSigned<D> di;
  const auto dx = hn::Add(hn::Iota(d, 0.0F), hn::Set(d, left));
  auto distance =
      hn::Add(hn::Mul(hn::Set(d, spatial_weight), hn::Mul(dx, dx)), hn::Set(d, spatial_dy));
  for (int c = 0; c < kChannels; ++c) {
    const auto difference = hn::Sub(hn::LoadU(d, channel[c]), hn::Set(d, centre.channel[c]));
    distance = hn::Add(distance, hn::Mul(difference, difference));
  }
  const auto before = hn::LoadU(d, nearest);
  const auto nearer = hn::Lt(distance, before);
  hn::StoreU(hn::IfThenElse(nearer, distance, before), d, nearest);
  const auto others = hn::LoadU(di, cluster);
  hn::StoreU(hn::IfThenElse(hn::RebindMask(di, nearer), hn::Set(di, label), others), di, cluster);
}

template <int kChannels, class D>
HWY_INLINE void AssignRows(D d, const ClusterWindow& w, const ClusterCentre& centre,
                           float spatial_weight, std::int32_t label) {
  const int lanes = static_cast<int>(hn::Lanes(d));
  for (int y = 0; y < w.height; ++y) {
    const float dy = static_cast<float>(w.y + y) - centre.y;
    for (int x = 0; x < w.width; x += lanes) {
      // The last vector overlaps the one before.
      const int begin = HWY_MIN(x, w.width - lanes);
      const std::ptrdiff_t offset = y * w.stride + begin;
      const float* channel[kChannels];
      for (int c = 0; c < kChannels; ++c) channel[c] = w.channel[c] + offset;
      AssignVector<kChannels>(d, channel, w.nearest + offset, w.cluster + offset, centre,
                              static_cast<float>(w.x + begin) - centre.x,
                              spatial_weight * (dy * dy), spatial_weight, label);
    }
  }
}

template <int kChannels>
HWY_INLINE void AssignChannels(const ClusterWindow& window, const ClusterCentre& centre,
                               float spatial_weight, std::int32_t label) {
  const hn::ScalableTag<float> wide;
  if (window.width >= static_cast<int>(hn::Lanes(wide))) {
    AssignRows<kChannels>(wide, window, centre, spatial_weight, label);
  } else {
    AssignRows<kChannels>(hn::CappedTag<float, 1>(), window, centre, spatial_weight, label);
  }
}

void AssignWindowTarget(const ClusterWindow& window, const ClusterCentre& centre,
                        float spatial_weight, std::int32_t label) {
  if (window.channels == 1) {
    AssignChannels<1>(window, centre, spatial_weight, label);
  } else {
    AssignChannels<3>(window, centre, spatial_weight, label);
  }
}

}  // namespace HWY_NAMESPACE
}  // namespace stereo_sgmp
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace stereo_sgmp {

HWY_EXPORT(AssignWindowTarget);

void AssignWindow(const ClusterWindow& window, const ClusterCentre& centre, float spatial_weight,
                  std::int32_t label) {
  HWY_DYNAMIC_DISPATCH(AssignWindowTarget)(window, centre, spatial_weight, label);
}

}  // namespace stereo_sgmp
#endif  // HWY_ONCE
