#include "refinement/plane_propagation_kernel.h"

#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "refinement/plane_propagation_kernel.cc"
#include <hwy/foreach_target.h>

#include <hwy/highway.h>

HWY_BEFORE_NAMESPACE();
namespace stereo_sgmp {
namespace HWY_NAMESPACE {

namespace hn = hwy::HWY_NAMESPACE;

using DF = HWY_CAPPED(float, PropagationStrip::kWidth);
using VF = hn::Vec<DF>;

constexpr float kRidge = 0.1f;    // px^2, added to both variances
constexpr float kMaxStep = 2.0f;  // pixels of disparity

// Weighted sums, x and y counted from the pixel where they stand.
struct Moments {
  VF n, x, xx, e, xe;
  VF y, xy, yy, ye;
};

HWY_INLINE Moments LoadRowSums(const PropagationStrip& strip, std::ptrdiff_t at) {
  const DF df;
  const VF zero = hn::Zero(df);
  return {hn::Load(df, strip.sums[0] + at),
          hn::Load(df, strip.sums[1] + at),
          hn::Load(df, strip.sums[2] + at),
          hn::Load(df, strip.sums[3] + at),
          hn::Load(df, strip.sums[4] + at),
          zero,
          zero,
          zero,
          zero};
}

HWY_INLINE void StoreMoments(const Moments& s, float* scratch) {
  const DF df;
  const VF values[] = {s.n, s.x, s.xx, s.e, s.xe, s.y, s.xy, s.yy, s.ye};
  for (const VF value : values) {
    hn::Store(value, df, scratch);
    scratch += hn::Lanes(df);
  }
}

HWY_INLINE Moments LoadMoments(const float* scratch) {
  const DF df;
  const std::size_t lanes = hn::Lanes(df);
  const auto load = [&](std::size_t i) HWY_ATTR { return hn::Load(df, scratch + i * lanes); };
  return {load(0), load(1), load(2), load(3), load(4), load(5), load(6), load(7), load(8)};
}

// The sums as the pixel below sees them, times the link to it.
HWY_INLINE Moments ToBelow(const Moments& s, VF link) {
  const VF twice_y = hn::Add(s.y, s.y);
  return {hn::Mul(link, s.n),
          hn::Mul(link, s.x),
          hn::Mul(link, s.xx),
          hn::Mul(link, s.e),
          hn::Mul(link, s.xe),
          hn::Mul(link, hn::Sub(s.y, s.n)),
          hn::Mul(link, hn::Sub(s.xy, s.x)),
          hn::Mul(link, hn::Add(hn::Sub(s.yy, twice_y), s.n)),
          hn::Mul(link, hn::Sub(s.ye, s.e))};
}

HWY_INLINE Moments ToAbove(const Moments& s, VF link) {
  const VF twice_y = hn::Add(s.y, s.y);
  return {hn::Mul(link, s.n),
          hn::Mul(link, s.x),
          hn::Mul(link, s.xx),
          hn::Mul(link, s.e),
          hn::Mul(link, s.xe),
          hn::Mul(link, hn::Add(s.y, s.n)),
          hn::Mul(link, hn::Add(s.xy, s.x)),
          hn::Mul(link, hn::Add(hn::Add(s.yy, twice_y), s.n)),
          hn::Mul(link, hn::Add(s.ye, s.e))};
}

HWY_INLINE Moments Sum(const Moments& a, const Moments& b) {
  return {hn::Add(a.n, b.n),   hn::Add(a.x, b.x),   hn::Add(a.xx, b.xx),
          hn::Add(a.e, b.e),   hn::Add(a.xe, b.xe), hn::Add(a.y, b.y),
          hn::Add(a.xy, b.xy), hn::Add(a.yy, b.yy), hn::Add(a.ye, b.ye)};
}

// Value at the pixel itself of the least-squares plane, about the mean.
HWY_INLINE VF PlaneValue(const Moments& s) {
  const VF ridge = hn::Mul(hn::Set(DF(), kRidge), s.n);
  const VF mean_x = hn::Div(s.x, s.n);
  const VF mean_y = hn::Div(s.y, s.n);
  const VF mean_e = hn::Div(s.e, s.n);
  const VF xx = hn::Add(hn::Sub(s.xx, hn::Mul(s.x, mean_x)), ridge);
  const VF xy = hn::Sub(s.xy, hn::Mul(s.x, mean_y));
  const VF yy = hn::Add(hn::Sub(s.yy, hn::Mul(s.y, mean_y)), ridge);
  const VF xe = hn::Sub(s.xe, hn::Mul(s.x, mean_e));
  const VF ye = hn::Sub(s.ye, hn::Mul(s.y, mean_e));
  const VF determinant = hn::Sub(hn::Mul(xx, yy), hn::Mul(xy, xy));
  const VF a = hn::Div(hn::Sub(hn::Mul(xe, yy), hn::Mul(ye, xy)), determinant);
  const VF b = hn::Div(hn::Sub(hn::Mul(ye, xx), hn::Mul(xe, xy)), determinant);
  return hn::Sub(hn::Sub(mean_e, hn::Mul(a, mean_x)), hn::Mul(b, mean_y));
}

HWY_INLINE void MoveToPlane(const Moments& sums, const float* share, float* disparity) {
  const DF df;
  const VF limit = hn::Set(df, kMaxStep);
  const VF d = hn::Load(df, disparity);
  const VF step = hn::Min(hn::Max(hn::Sub(PlaneValue(sums), d), hn::Neg(limit)), limit);
  hn::Store(hn::Add(d, hn::Mul(hn::Load(df, share), step)), df, disparity);
}

// The columns from `x` of the strip on, as many as a vector holds: down with what comes from
// above each pixel, and up with what comes from below.
void PropagateVector(const PropagationStrip& strip, std::ptrdiff_t x) {
  const DF df;
  const std::ptrdiff_t step =
      PropagationStrip::kMoments * static_cast<std::ptrdiff_t>(hn::Lanes(df));
  Moments sums = LoadRowSums(strip, x);
  StoreMoments(sums, strip.scratch);
  for (int y = 1; y < strip.height; ++y) {
    const std::ptrdiff_t at = y * strip.stride + x;
    sums = Sum(LoadRowSums(strip, at), ToBelow(sums, hn::Load(df, strip.down + at)));
    StoreMoments(sums, strip.scratch + y * step);
  }
  const std::ptrdiff_t last = (strip.height - 1) * strip.stride + x;
  MoveToPlane(sums, strip.share + last, strip.disparity + last);
  sums = LoadRowSums(strip, last);
  for (int y = strip.height - 2; y >= 0; --y) {
    const std::ptrdiff_t at = y * strip.stride + x;
    const Moments below = ToAbove(sums, hn::Load(df, strip.down + at + strip.stride));
    MoveToPlane(Sum(LoadMoments(strip.scratch + y * step), below), strip.share + at,
                strip.disparity + at);
    sums = Sum(LoadRowSums(strip, at), below);
  }
}

void PropagateDownColumnsOnTarget(const PropagationStrip& strip) {
  const std::ptrdiff_t lanes = static_cast<std::ptrdiff_t>(hn::Lanes(DF()));
  for (std::ptrdiff_t x = 0; x < PropagationStrip::kWidth; x += lanes) PropagateVector(strip, x);
}

}  // namespace HWY_NAMESPACE
}  // namespace stereo_sgmp
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace stereo_sgmp {

HWY_EXPORT(PropagateDownColumnsOnTarget);

void PropagateDownColumns(const PropagationStrip& strip) {
  HWY_DYNAMIC_DISPATCH(PropagateDownColumnsOnTarget)(strip);
}

}  // namespace stereo_sgmp
#endif
