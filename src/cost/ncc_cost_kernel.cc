#include "cost/ncc_cost_kernel.h"

#include <algorithm>

#include "cost/match_span.h"

#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "cost/ncc_cost_kernel.cc"
#include <hwy/foreach_target.h>
#include <hwy/highway.h>

HWY_BEFORE_NAMESPACE();
namespace stereo_sgmp {
namespace HWY_NAMESPACE {
namespace hn = hwy::HWY_NAMESPACE;

using D32 = hn::CappedTag<std::int32_t, 16>;
using DF = hn::RebindToFloat<D32>;
using V32 = hn::Vec<D32>;

constexpr int kColumns = 2 * kPatchRadius + 1;
// Disparities worked on at a time: the sums of all columns of a patch then stay in the L1 cache.
constexpr int kBlock = 256;

// 25 times the products of the left and right pixels in one column of two patches, summed, per
// disparity, for the latest columns.
struct ColumnSums {
  HWY_ALIGN std::int32_t ring[kColumns][kBlock];

  std::int32_t* Column(int x) { return ring[(x + kPatchRadius) % kColumns]; }
  const std::int32_t* Column(int x) const { return ring[(x + kPatchRadius) % kColumns]; }
};

// Added to a float of 0 to 2^22, leaves the nearest whole number in its lowest bits.
constexpr float kRoundingBias = 12582912.0F;

// sum + a_low b_low + a_high b_high of pairs of signed 16-bit numbers in each 32 bits.
HWY_INLINE V32 PairDot([[maybe_unused]] D32 d32, V32 a, V32 b, V32 sum) {
#if HWY_TARGET == HWY_SCALAR
  const V32 low =
      hn::Mul(hn::ShiftRight<16>(hn::ShiftLeft<16>(a)), hn::ShiftRight<16>(hn::ShiftLeft<16>(b)));
  const V32 high = hn::Mul(hn::ShiftRight<16>(a), hn::ShiftRight<16>(b));
  return hn::Add(sum, hn::Add(low, high));
#else
  const hn::Repartition<std::int16_t, D32> d16;
  V32 odd = hn::Zero(d32);
  const V32 even =
      hn::ReorderWidenMulAccumulate(d32, hn::BitCast(d16, a), hn::BitCast(d16, b), sum, odd);
  return hn::RearrangeToOddPlusEven(even, odd);
#endif
}

// Disparity indices of the block that begins at `first`, out of those whose match column lies
// inside the image widened by `border`, relative to the block.
HWY_INLINE MatchSpan BlockSpan(const VolumeShape& shape, int x, int first, int border) {
  const int last = x - shape.min_disparity + border - first;
  return ClippedSpan(last - (shape.width - 1) - 2 * border, last,
                     std::min(kBlock, shape.disparities - first));
}

void SumColumn(const NccRows& rows, int right_row, const VolumeShape& shape, int x, int first,
               std::int32_t* sums) {
  const D32 d32;
  const int lanes = static_cast<int>(hn::Lanes(d32));
  const int left_y = rows.left_y - kPatchRadius;
  const int right_y = rows.right_first + right_row - kPatchRadius;
  // 25 times a pair are both of its numbers times 25; the last one is left out, as patches have
  // an odd height.
  const V32 left0 = hn::Set(d32, kPatchPixels * rows.left->Pairs(left_y)[x]);
  const V32 left2 = hn::Set(d32, kPatchPixels * rows.left->Pairs(left_y + 2)[x]);
  const V32 left4 = hn::Set(d32, kPatchPixels * (rows.left->Pairs(left_y + 4)[x] & 0xFFFF));
  const std::ptrdiff_t match = MirroredColumn(shape, x) + first;
  const std::int32_t* right0 = rows.right->Pairs(right_y) + match;
  const std::int32_t* right2 = rows.right->Pairs(right_y + 2) + match;
  const std::int32_t* right4 = rows.right->Pairs(right_y + 4) + match;
  const MatchSpan span = BlockSpan(shape, x, first, kPatchRadius);
  for (int k = span.begin / lanes * lanes; k < span.end; k += lanes) {
    V32 sum = PairDot(d32, left0, hn::LoadU(d32, right0 + k), hn::Zero(d32));
    sum = PairDot(d32, left2, hn::LoadU(d32, right2 + k), sum);
    sum = PairDot(d32, left4, hn::LoadU(d32, right4 + k), sum);
    hn::Store(sum, d32, sums + k);
  }
}

// 625 times the covariance of the patches: 25 sum l r - sum l sum r, exactly.
HWY_INLINE V32 Covariance(D32 d32, const ColumnSums& sums, int x, int k, V32 minus_left_sum,
                          V32 right_sum) {
  V32 sum = PairDot(d32, minus_left_sum, right_sum, hn::Zero(d32));
  for (int dx = -kPatchRadius; dx <= kPatchRadius; ++dx) {
    sum = hn::Add(sum, hn::Load(d32, sums.Column(x + dx) + k));
  }
  return sum;
}

// Costs of the pixel x and the block of disparities that begins at `first`.
template <int kRightCount>
void CostOfBlock(const NccRows& rows, const VolumeShape& shape, float epsilon, int x, int first,
                 const ColumnSums* sums, std::uint8_t* costs) {
  const D32 d32;
  const DF df;
  const hn::Rebind<std::uint8_t, D32> d8;
  const int lanes = static_cast<int>(hn::Lanes(d32));
  const std::ptrdiff_t match = MirroredColumn(shape, x) + first;
  const std::int32_t* right_sums[kRightCount];
  const float* right_deviations[kRightCount];
  for (int i = 0; i < kRightCount; ++i) {
    right_sums[i] = rows.right->Sums(rows.right_first + i) + match;
    right_deviations[i] = rows.right->Deviations(rows.right_first + i) + match;
  }
  const V32 minus_left_sum = hn::Set(d32, -rows.left->Sums(rows.left_y)[x]);
  const auto left_deviation = hn::Set(df, rows.left->Deviations(rows.left_y)[x]);
  const auto scaled_epsilon = hn::Set(df, static_cast<float>(kPatchPixels) * epsilon);
  const MatchSpan span = BlockSpan(shape, x, first, 0);
  for (int k = span.begin / lanes * lanes; k < span.end; k += lanes) {
    auto ncc = hn::Zero(df);
    for (int i = 0; i < kRightCount; ++i) {
      const V32 right_sum = hn::LoadU(d32, right_sums[i] + k);
      const V32 covariance = Covariance(d32, sums[i], x, k, minus_left_sum, right_sum);
      const auto deviations = hn::Mul(left_deviation, hn::LoadU(df, right_deviations[i] + k));
      ncc =
          hn::Max(ncc, hn::Div(hn::ConvertTo(df, covariance), hn::Add(deviations, scaled_epsilon)));
    }
    const auto cost = hn::Mul(hn::Sub(hn::Set(df, 1.0F), ncc), hn::Set(df, 255.0F));
    const auto biased = hn::Add(cost, hn::Set(df, kRoundingBias));
    const hn::RebindToUnsigned<D32> du32;
    hn::StoreU(hn::TruncateTo(d8, hn::BitCast(du32, biased)), d8, costs + k);
  }
}

template <int kRightCount>
void NccRow(const NccRows& rows, const VolumeShape& shape, float epsilon, std::uint8_t* costs) {
  ColumnSums sums[kRightCount];
  const std::ptrdiff_t stride = shape.Stride();
  const auto sum_column = [&](int x, int first) {
    for (int i = 0; i < kRightCount; ++i) {
      SumColumn(rows, i, shape, x, first, sums[i].Column(x));
    }
  };
  for (int first = 0; first < shape.disparities; first += kBlock) {
    for (int x = -kPatchRadius; x < kPatchRadius; ++x) sum_column(x, first);
    for (int x = 0; x < shape.width; ++x) {
      sum_column(x + kPatchRadius, first);
      CostOfBlock<kRightCount>(rows, shape, epsilon, x, first, sums, costs + x * stride + first);
    }
  }
  for (int x = 0; x < shape.width; ++x) {
    FillOutside(shape, InsideSpan(shape, x), kNccOutsideCost, costs + x * stride);
  }
}

void NccRowByCount(const NccRows& rows, const VolumeShape& shape, float epsilon,
                   std::uint8_t* costs) {
  static_assert(NccRows::kMaxRightCount == 3);
  if (rows.right_count == 1) {
    NccRow<1>(rows, shape, epsilon, costs);
  } else if (rows.right_count == 2) {
    NccRow<2>(rows, shape, epsilon, costs);
  } else {
    NccRow<3>(rows, shape, epsilon, costs);
  }
}

}  // namespace HWY_NAMESPACE
}  // namespace stereo_sgmp
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace stereo_sgmp {

HWY_EXPORT(NccRowByCount);

void NccCostRow(const NccRows& rows, const VolumeShape& shape, float epsilon, std::uint8_t* costs) {
  HWY_DYNAMIC_DISPATCH(NccRowByCount)(rows, shape, epsilon, costs);
}

}  // namespace stereo_sgmp
#endif  // HWY_ONCE
