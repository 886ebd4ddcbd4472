#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "prior/plane_seed_kernel.cc"
#include <hwy/foreach_target.h>  // must come before highway.h

#include <hwy/highway.h>

#include "prior/plane_seed_kernel.h"

#ifndef STEREO_SGMP_PRIOR_PLANE_SEED_KERNEL_ONCE
#define STEREO_SGMP_PRIOR_PLANE_SEED_KERNEL_ONCE

#include <cstddef>
#include <cstdint>
#include <limits>

#include "prior/plane_fit.h"

namespace stereo_sgmp {
namespace plane_seed {

constexpr int kSide = 2 * kSeedRadius + 1;
constexpr int kColumns = (kSide + kSeedStep - 1) / kSeedStep * kSeedStep;  // the last is not used
constexpr double kPixels = kSide * kSide;
// A window holds the disparities this close to that of its centre; wide enough for a slant of
// 0.4 a pixel, narrow enough to leave out most of what lies behind.
constexpr float kRange = 2.0F;
// Share of the window that must be filled, and what each missing share costs in the ranking.
constexpr double kFill = 0.6;
constexpr double kMissingPenalty = 0.1;

// Sums over the pixels of each window in one of its columns: their number, and moments of y and d.
struct ColumnSums {
  HWY_ALIGN float n[kSeedBatch];
  HWY_ALIGN float y[kSeedBatch];
  HWY_ALIGN float d[kSeedBatch];
  HWY_ALIGN float yy[kSeedBatch];
  HWY_ALIGN float yd[kSeedBatch];
  HWY_ALIGN float dd[kSeedBatch];
};

}  // namespace plane_seed
}  // namespace stereo_sgmp

#endif  // STEREO_SGMP_PRIOR_PLANE_SEED_KERNEL_ONCE

HWY_BEFORE_NAMESPACE();
namespace stereo_sgmp {
namespace HWY_NAMESPACE {
namespace hn = hwy::HWY_NAMESPACE;

using Floats = hn::CappedTag<float, kSeedBatch>;
using Doubles = hn::CappedTag<double, kSeedBatch / 2>;
using VF = hn::Vec<Floats>;
using VD = hn::Vec<Doubles>;

struct Sums {
  VF n, y, d, yy, yd, dd;
};

HWY_INLINE void AddRow(VF value, VF centre, float y, Sums& sums) {
  const Floats f;
  const VF difference = hn::Sub(value, centre);
  const auto near = hn::Lt(hn::Abs(difference), hn::Set(f, plane_seed::kRange));
  const VF d = hn::IfThenElseZero(near, difference);
  sums.n = hn::Add(sums.n, hn::IfThenElseZero(near, hn::Set(f, 1.0F)));
  sums.y = hn::Add(sums.y, hn::IfThenElseZero(near, hn::Set(f, y)));
  sums.d = hn::Add(sums.d, d);
  sums.yy = hn::Add(sums.yy, hn::IfThenElseZero(near, hn::Set(f, y * y)));
  sums.yd = hn::Add(sums.yd, hn::Mul(d, hn::Set(f, y)));
  sums.dd = hn::Add(sums.dd, hn::Mul(d, d));
}

HWY_INLINE void StoreSums(const Sums& sums, int window, plane_seed::ColumnSums* column) {
  const Floats f;
  hn::Store(sums.n, f, column->n + window);
  hn::Store(sums.y, f, column->y + window);
  hn::Store(sums.d, f, column->d + window);
  hn::Store(sums.yy, f, column->yy + window);
  hn::Store(sums.yd, f, column->yd + window);
  hn::Store(sums.dd, f, column->dd + window);
}

// The three columns of each window from `column` on. The step of the windows is the number of
// vectors that a load takes apart.
HWY_INLINE void SumColumns(const float* centre, int stride, int column, int window,
                           plane_seed::ColumnSums* columns) {
  static_assert(kSeedStep == 3, "of LoadInterleaved3");
  const Floats f;
  const VF zero = hn::Zero(f);
  Sums sums0{zero, zero, zero, zero, zero, zero};
  Sums sums1 = sums0;
  Sums sums2 = sums0;
  VF centres, unused1, unused2;
  hn::LoadInterleaved3(f, centre, centres, unused1, unused2);
  for (int dy = -kSeedRadius; dy <= kSeedRadius; ++dy) {
    VF value0, value1, value2;
    hn::LoadInterleaved3(f,
                         centre + static_cast<std::ptrdiff_t>(dy) * stride - kSeedRadius + column,
                         value0, value1, value2);
    const float y = static_cast<float>(dy);
    AddRow(value0, centres, y, sums0);
    AddRow(value1, centres, y, sums1);
    AddRow(value2, centres, y, sums2);
  }
  StoreSums(sums0, window, columns + column);
  StoreSums(sums1, window, columns + column + 1);
  StoreSums(sums2, window, columns + column + 2);
}

// PlaneMoments, for as many windows as there are lanes.
struct Moments {
  VD n, x, y, d, xx, xy, yy, xd, yd, dd;
};

HWY_INLINE VD LoadSum(const float* sums) {
  const Doubles d;
  return hn::PromoteTo(d, hn::LoadU(hn::Rebind<float, Doubles>(), sums));
}

HWY_INLINE Moments MomentsOf(const plane_seed::ColumnSums* columns, int window) {
  const Doubles tag;
  const VD zero = hn::Zero(tag);
  Moments m{zero, zero, zero, zero, zero, zero, zero, zero, zero, zero};
  for (int i = 0; i < plane_seed::kSide; ++i) {
    const plane_seed::ColumnSums& column = columns[i];
    const VD x = hn::Set(tag, static_cast<double>(i - kSeedRadius));
    const VD n = LoadSum(column.n + window);
    const VD y = LoadSum(column.y + window);
    const VD d = LoadSum(column.d + window);
    const VD nx = hn::Mul(n, x);
    m.n = hn::Add(m.n, n);
    m.x = hn::Add(m.x, nx);
    m.y = hn::Add(m.y, y);
    m.d = hn::Add(m.d, d);
    m.xx = hn::Add(m.xx, hn::Mul(nx, x));
    m.xy = hn::Add(m.xy, hn::Mul(y, x));
    m.yy = hn::Add(m.yy, LoadSum(column.yy + window));
    m.xd = hn::Add(m.xd, hn::Mul(d, x));
    m.yd = hn::Add(m.yd, LoadSum(column.yd + window));
    m.dd = hn::Add(m.dd, LoadSum(column.dd + window));
  }
  return m;
}

// Means, and mean products of the deviations from them.
HWY_INLINE Moments AboutMean(const Moments& sums) {
  const VD n = sums.n;
  Moments m = sums;
  m.x = hn::Div(sums.x, n);
  m.y = hn::Div(sums.y, n);
  m.d = hn::Div(sums.d, n);
  m.xx = hn::Sub(hn::Div(sums.xx, n), hn::Mul(m.x, m.x));
  m.xy = hn::Sub(hn::Div(sums.xy, n), hn::Mul(m.x, m.y));
  m.yy = hn::Sub(hn::Div(sums.yy, n), hn::Mul(m.y, m.y));
  m.xd = hn::Sub(hn::Div(sums.xd, n), hn::Mul(m.x, m.d));
  m.yd = hn::Sub(hn::Div(sums.yd, n), hn::Mul(m.y, m.d));
  m.dd = hn::Sub(hn::Div(sums.dd, n), hn::Mul(m.d, m.d));
  return m;
}

struct Planes {
  VD a, b, c;
};

// PlaneMoments::Fit.
HWY_INLINE Planes FitPlanes(const Moments& m) {
  const Doubles tag;
  const VD regularisation = hn::Set(tag, kSlopeRegularisation);
  const VD xx = hn::Add(m.xx, regularisation);
  const VD yy = hn::Add(m.yy, regularisation);
  const VD determinant = hn::Sub(hn::Mul(xx, yy), hn::Mul(m.xy, m.xy));
  const VD a = hn::Div(hn::Sub(hn::Mul(m.xd, yy), hn::Mul(m.yd, m.xy)), determinant);
  const VD b = hn::Div(hn::Sub(hn::Mul(m.yd, xx), hn::Mul(m.xd, m.xy)), determinant);
  return {a, b, hn::Sub(hn::Sub(m.d, hn::Mul(a, m.x)), hn::Mul(b, m.y))};
}

// PlaneMoments::Rms.
HWY_INLINE VD RmsOf(const Planes& plane, const Moments& m) {
  const Doubles tag;
  const VD a = plane.a;
  const VD b = plane.b;
  const VD two = hn::Set(tag, 2.0);
  const VD at_mean = hn::Add(hn::Add(hn::Mul(a, m.x), hn::Mul(b, m.y)), plane.c);
  const VD offset = hn::Sub(at_mean, m.d);
  VD square = hn::Sub(m.dd, hn::Mul(two, hn::Add(hn::Mul(a, m.xd), hn::Mul(b, m.yd))));
  square = hn::Add(square, hn::Mul(hn::Mul(a, a), m.xx));
  square = hn::Add(square, hn::Mul(hn::Mul(hn::Mul(two, a), b), m.xy));
  square = hn::Add(square, hn::Mul(hn::Mul(b, b), m.yy));
  square = hn::Add(square, hn::Mul(offset, offset));
  return hn::Sqrt(hn::Max(hn::Zero(tag), square));
}

HWY_INLINE void FitWindows(const plane_seed::ColumnSums* columns, int window, SeedBatch* seeds) {
  const Doubles tag;
  const Moments m = AboutMean(MomentsOf(columns, window));
  const Planes plane = FitPlanes(m);
  const VD fill = hn::Div(m.n, hn::Set(tag, plane_seed::kPixels));
  const VD missing = hn::Sub(hn::Set(tag, 1.0), fill);
  const VD rank =
      hn::Add(RmsOf(plane, m), hn::Mul(hn::Set(tag, plane_seed::kMissingPenalty), missing));
  const auto filled = hn::Ge(fill, hn::Set(tag, plane_seed::kFill));
  const VD none = hn::Set(tag, std::numeric_limits<double>::infinity());
  const auto i = static_cast<std::size_t>(window);
  hn::StoreU(hn::IfThenElse(filled, rank, none), tag, &seeds->rank[i]);
  hn::StoreU(plane.a, tag, &seeds->a[i]);
  hn::StoreU(plane.b, tag, &seeds->b[i]);
  hn::StoreU(plane.c, tag, &seeds->c[i]);
}

void FitSeedsOnTarget(const float* centre, int stride, SeedBatch* seeds) {
  const int lanes = static_cast<int>(hn::Lanes(Floats()));
  plane_seed::ColumnSums columns[plane_seed::kColumns];
  for (int window = 0; window < kSeedBatch; window += lanes) {
    for (int column = 0; column < plane_seed::kColumns; column += kSeedStep) {
      SumColumns(centre + kSeedStep * window, stride, column, window, columns);
    }
  }
  const int windows = static_cast<int>(hn::Lanes(Doubles()));
  for (int window = 0; window < kSeedBatch; window += windows) {
    FitWindows(columns, window, seeds);
  }
}

}  // namespace HWY_NAMESPACE
}  // namespace stereo_sgmp
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace stereo_sgmp {

HWY_EXPORT(FitSeedsOnTarget);

void FitSeeds(const float* centre, int stride, SeedBatch* seeds) {
  HWY_DYNAMIC_DISPATCH(FitSeedsOnTarget)(centre, stride, seeds);
}

}  // namespace stereo_sgmp
#endif  // HWY_ONCE
