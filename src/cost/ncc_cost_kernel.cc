#include "cost/ncc_cost_kernel.h"

#include <algorithm>

#include "cost/match_span.h"

#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "cost/ncc_cost_kernel.cc"
#include <hwy/foreach_target.h>

#include <hwy/highway.h>

#include "cost/pair_dot-inl.h"

HWY_BEFORE_NAMESPACE();
namespace stereo_sgmp {
namespace HWY_NAMESPACE {
namespace hn = hwy::HWY_NAMESPACE;

using D32 = hn::CappedTag<std::int32_t, 16>;
using DF = hn::RebindToFloat<D32>;
using V32 = hn::Vec<D32>;
using VF = hn::Vec<DF>;

constexpr int kColumns = 2 * kPatchRadius + 1;
// Disparities worked on at a time: the sums of all columns of a patch then stay in the L1 cache.
constexpr int kBlock = 256;

// Products of the left and right pixels in one column of two patches, summed, times 25, for the
// latest columns, and the sums of as many columns as a patch has: a vector of disparities for each
// row of right patches, then the next disparities. So they lie close together, however many
// disparities there are, and no part of the first-level cache has to hold more than others.
template <int kRightCount>
struct ColumnSums {
  HWY_ALIGN std::int32_t ring[kColumns][kRightCount * kBlock];
  HWY_ALIGN std::int32_t patch[kRightCount * kBlock];

  // For x >= -2 kColumns.
  std::int32_t* Column(int x) { return ring[(x + 2 * kColumns) % kColumns]; }
};

// Added to a float of 0 to 2^22, leaves the nearest whole number in its lowest bits.
constexpr float kRoundingBias = 12582912.0F;

// Disparity indices of the block that begins at `first`, out of those whose match column lies
// inside the image widened by `border`, relative to the block.
HWY_INLINE MatchSpan BlockSpan(const VolumeShape& shape, int x, int first, int border) {
  const int last = x - shape.min_disparity + border - first;
  return ClippedSpan(last - (shape.width - 1) - 2 * border, last,
                     std::min(kBlock, shape.disparities - first));
}

// Row pairs that the patches of kRightCount rows of patches cover.
constexpr int PairCount(int right_count) { return (kColumns + right_count) / 2; }

// The pixels of one column of a left patch, times 25, as the factors of pairs of right rows.
struct LeftColumn {
  V32 from_first[3];   // of patches that begin with the first row of a pair
  V32 from_second[3];  // with the second
};

HWY_INLINE LeftColumn LeftColumnAt(const NccRows& rows, int x) {
  const D32 d32;
  const auto pair = [&](int dy) { return kPatchPixels * rows.left->Pairs(rows.left_y + dy)[x]; };
  const auto first_of = [](std::int32_t both) { return both & 0xFFFF; };
  const auto second_of = [&](int dy) { return first_of(pair(dy)) << 16; };
  return {{hn::Set(d32, pair(-2)), hn::Set(d32, pair(0)), hn::Set(d32, first_of(pair(2)))},
          {hn::Set(d32, second_of(-2)), hn::Set(d32, pair(-1)), hn::Set(d32, pair(1))}};
}

// 25 times the products in one column of the left patch and of that of right row i.
HWY_INLINE V32 ColumnSum(const LeftColumn& left, const V32* right_pairs, int i) {
  const D32 d32;
  const V32* factors = i % 2 == 0 ? left.from_first : left.from_second;
  V32 sum = PairDot(d32, factors[0], right_pairs[i / 2], hn::Zero(d32));
  sum = PairDot(d32, factors[1], right_pairs[i / 2 + 1], sum);
  return PairDot(d32, factors[2], right_pairs[i / 2 + 2], sum);
}

// round(255 (1 - ncc)) in the lowest bits.
HWY_INLINE V32 RoundedCost(VF ncc) {
  const DF df;
  const VF cost = hn::Mul(hn::Sub(hn::Set(df, 1.0F), ncc), hn::Set(df, 255.0F));
  return hn::BitCast(D32(), hn::Add(cost, hn::Set(df, kRoundingBias)));
}

// Sums the column x + kPatchRadius for the block of disparities that begins at `first`, and with
// kCosts gives the costs of the pixel x.
template <int kRightCount, bool kCosts>
HWY_INLINE void NccBlock(const NccRows& rows, const VolumeShape& shape, float epsilon, int x,
                         int first, ColumnSums<kRightCount>* sums,
                         std::uint8_t* HWY_RESTRICT costs) {
  constexpr int kPairs = PairCount(kRightCount);
  const D32 d32;
  const DF df;
  const hn::RebindToUnsigned<D32> du32;
  const hn::Rebind<std::uint8_t, D32> d8;
  const int lanes = static_cast<int>(hn::Lanes(d32));

  const int column = x + kPatchRadius;
  const LeftColumn left = LeftColumnAt(rows, column);
  const std::int32_t* pairs[kPairs];
  for (int j = 0; j < kPairs; ++j) {
    pairs[j] = rows.right->Pairs(rows.right_first - kPatchRadius + 2 * j) +
               MirroredColumn(shape, column) + first;
  }
  const std::ptrdiff_t match = MirroredColumn(shape, x) + first;
  const std::int32_t* right_sums[kRightCount];
  const float* right_deviations[kRightCount];
  for (int i = 0; i < kRightCount; ++i) {
    right_sums[i] = rows.right->Sums(rows.right_first + i) + match;
    right_deviations[i] = rows.right->Deviations(rows.right_first + i) + match;
  }
  const V32 minus_left_sum = hn::Set(d32, kCosts ? -rows.left->Sums(rows.left_y)[x] : 0);
  const auto left_deviation = hn::Set(df, kCosts ? rows.left->Deviations(rows.left_y)[x] : 0.0F);
  const auto scaled_epsilon = hn::Set(df, static_cast<float>(kPatchPixels) * epsilon);

  const MatchSpan span = BlockSpan(shape, column, first, kPatchRadius);
  std::int32_t* const column_sums = sums->Column(column);
  for (int k = span.begin / lanes * lanes; k < span.end; k += lanes) {
    V32 right[kPairs];
    for (int j = 0; j < kPairs; ++j) right[j] = hn::LoadU(d32, pairs[j] + k);
    VF ncc = hn::Zero(df);
    for (int i = 0; i < kRightCount; ++i) {
      const int place = k * kRightCount + i * lanes;
      const V32 latest = ColumnSum(left, right, i);
      // 0 for disparities whose matches have just entered the image.
      const V32 leaves = hn::Load(d32, column_sums + place);
      const V32 others = hn::Sub(hn::Load(d32, sums->patch + place), leaves);
      const V32 patch = hn::Add(others, latest);
      hn::Store(latest, d32, column_sums + place);
      hn::Store(patch, d32, sums->patch + place);
      if (!kCosts) continue;
      // 625 times the covariance of the patches: 25 sum l r - sum l sum r, exactly.
      const V32 covariance = PairDot(d32, minus_left_sum, hn::LoadU(d32, right_sums[i] + k), patch);
      const VF deviations = hn::Mul(left_deviation, hn::LoadU(df, right_deviations[i] + k));
      const VF divisor = hn::Add(deviations, scaled_epsilon);
      ncc = hn::Max(ncc, hn::Div(hn::ConvertTo(df, covariance), divisor));
    }
    if (!kCosts) continue;
    hn::StoreU(hn::TruncateTo(d8, hn::BitCast(du32, RoundedCost(ncc))), d8, costs + k);
  }
}

template <int kRightCount>
void NccRow(const NccRows& rows, const VolumeShape& shape, float epsilon, std::uint8_t* costs) {
  // Costs outside the image are computed, from whatever stands there, and replaced in the end.
  const std::ptrdiff_t stride = shape.Stride();
  for (int first = 0; first < shape.disparities; first += kBlock) {
    ColumnSums<kRightCount> sums = {};
    for (int x = -2 * kPatchRadius; x < 0; ++x) {
      NccBlock<kRightCount, false>(rows, shape, epsilon, x, first, &sums, nullptr);
    }
    for (int x = 0; x < shape.width; ++x) {
      NccBlock<kRightCount, true>(rows, shape, epsilon, x, first, &sums,
                                  costs + x * stride + first);
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
