#include "refinement/plane_smoothing_kernel.h"

#include <cstring>

#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "refinement/plane_smoothing_kernel.cc"
#include <hwy/foreach_target.h>

#include <hwy/highway.h>

HWY_BEFORE_NAMESPACE();
namespace stereo_sgmp {
namespace HWY_NAMESPACE {

namespace hn = hwy::HWY_NAMESPACE;

using DF = HWY_CAPPED(float, kSmoothingOverhang);
using DI = hn::Rebind<std::int32_t, DF>;
using DB = hn::Rebind<std::uint8_t, DF>;
using VF = hn::Vec<DF>;

// A neighbour takes part if it differs by kTolerance + kTolerancePerPixel max(|dx|, |dy|) at most.
constexpr float kTolerance = 1.0f;
constexpr float kTolerancePerPixel = 0.1f;
// Variance added to both axes, px^2: holds the slopes where the neighbours are few or in a line.
constexpr float kRidge = 0.3f;
constexpr float kMinWeight = 2.5f;      // below, the pixel stays as it is
constexpr float kMaxCorrection = 1.0f;  // pixels

// Weighted sums over the neighbours: e is the disparity less that of the pixel itself.
struct Moments {
  VF n, x, y, xx, xy, yy, e, xe, ye;
};

// The same over one row of the window, where dy is constant.
struct RowMoments {
  VF n, x, xx, e, xe;
};

template <int kChannels>
HWY_INLINE VF Weight(const SmoothingRow& row, const hn::Vec<DB> (&center)[kChannels],
                     std::ptrdiff_t neighbour) {
  const DB db;
  auto largest = hn::Zero(db);
  for (int c = 0; c < kChannels; ++c) {
    const auto value = hn::LoadU(db, row.channels[c] + neighbour);
    largest = hn::Max(largest, hn::Sub(hn::Max(value, center[c]), hn::Min(value, center[c])));
  }
  return hn::GatherIndex(DF(), row.weight, hn::PromoteTo(DI(), largest));
}

template <int kChannels>
HWY_INLINE RowMoments SumWindowRow(const SmoothingRow& row, std::ptrdiff_t x, int dy, VF disparity,
                                   const hn::Vec<DB> (&center)[kChannels]) {
  const DF df;
  const VF zero = hn::Zero(df);
  RowMoments sums = {zero, zero, zero, zero, zero};
  for (int dx = -kSmoothingRadius; dx <= kSmoothingRadius; dx += kSmoothingStep) {
    const std::ptrdiff_t neighbour = x + dy * row.stride + dx;
    const int distance = HWY_MAX(dx < 0 ? -dx : dx, dy < 0 ? -dy : dy);
    const VF tolerance =
        hn::Set(df, kTolerance + kTolerancePerPixel * static_cast<float>(distance));
    const VF e = hn::Sub(hn::LoadU(df, row.disparity + neighbour), disparity);
    const VF w = hn::IfThenElseZero(hn::Le(hn::Abs(e), tolerance),
                                    Weight<kChannels>(row, center, neighbour));
    const VF vdx = hn::Set(df, static_cast<float>(dx));
    const VF wx = hn::Mul(w, vdx);
    const VF we = hn::Mul(w, e);
    sums.n = hn::Add(sums.n, w);
    sums.x = hn::Add(sums.x, wx);
    sums.xx = hn::Add(sums.xx, hn::Mul(wx, vdx));
    sums.e = hn::Add(sums.e, we);
    sums.xe = hn::Add(sums.xe, hn::Mul(we, vdx));
  }
  return sums;
}

HWY_INLINE void AddWindowRow(const RowMoments& row, int dy, Moments* sums) {
  const VF vdy = hn::Set(DF(), static_cast<float>(dy));
  const VF y = hn::Mul(row.n, vdy);
  sums->n = hn::Add(sums->n, row.n);
  sums->x = hn::Add(sums->x, row.x);
  sums->y = hn::Add(sums->y, y);
  sums->xx = hn::Add(sums->xx, row.xx);
  sums->xy = hn::Add(sums->xy, hn::Mul(row.x, vdy));
  sums->yy = hn::Add(sums->yy, hn::Mul(y, vdy));
  sums->e = hn::Add(sums->e, row.e);
  sums->xe = hn::Add(sums->xe, row.xe);
  sums->ye = hn::Add(sums->ye, hn::Mul(row.e, vdy));
}

template <int kChannels>
HWY_INLINE Moments SumWindow(const SmoothingRow& row, std::ptrdiff_t x, VF disparity) {
  const DB db;
  hn::Vec<DB> center[kChannels];
  for (int c = 0; c < kChannels; ++c) center[c] = hn::LoadU(db, row.channels[c] + x);
  const VF zero = hn::Zero(DF());
  Moments sums = {zero, zero, zero, zero, zero, zero, zero, zero, zero};
  for (int dy = -kSmoothingRadius; dy <= kSmoothingRadius; dy += kSmoothingStep) {
    AddWindowRow(SumWindowRow<kChannels>(row, x, dy, disparity, center), dy, &sums);
  }
  return sums;
}

// Value at the pixel itself of the least-squares plane e = a dx + b dy + c, about the mean.
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

// The vector of pixels that starts at x; `disparity` points at the first of them.
template <int kChannels>
HWY_INLINE void SmoothVector(const SmoothingRow& row, std::ptrdiff_t x, float* disparity) {
  const DF df;
  const VF d = hn::LoadU(df, disparity);
  const Moments sums = SumWindow<kChannels>(row, x, d);
  const VF limit = hn::Set(df, kMaxCorrection);
  const VF correction = hn::Min(hn::Max(PlaneValue(sums), hn::Neg(limit)), limit);
  const auto enough = hn::Ge(sums.n, hn::Set(df, kMinWeight));
  hn::StoreU(hn::IfThenElse(enough, hn::Add(d, correction), d), df, disparity);
}

template <int kChannels>
void SmoothRow(const SmoothingRow& row, int width, float* disparity) {
  const int lanes = static_cast<int>(hn::Lanes(DF()));
  int x = 0;
  for (; x + lanes <= width; x += lanes) SmoothVector<kChannels>(row, x, disparity + x);
  if (x >= width) return;
  float rest[kSmoothingOverhang] = {};
  const std::size_t rest_bytes = static_cast<std::size_t>(width - x) * sizeof(float);
  std::memcpy(rest, disparity + x, rest_bytes);
  SmoothVector<kChannels>(row, x, rest);
  std::memcpy(disparity + x, rest, rest_bytes);
}

void SmoothPlaneRowOnTarget(const SmoothingRow& row, int width, float* disparity) {
  if (row.channel_count == 1) {
    SmoothRow<1>(row, width, disparity);
  } else {
    SmoothRow<3>(row, width, disparity);
  }
}

}  // namespace HWY_NAMESPACE
}  // namespace stereo_sgmp
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace stereo_sgmp {

HWY_EXPORT(SmoothPlaneRowOnTarget);

void SmoothPlaneRow(const SmoothingRow& row, int width, float* disparity) {
  HWY_DYNAMIC_DISPATCH(SmoothPlaneRowOnTarget)(row, width, disparity);
}

}  // namespace stereo_sgmp
#endif
