// Counting the bits of bytes is one instruction from this target on.
#ifndef HWY_WANT_AVX3_DL
#define HWY_WANT_AVX3_DL
#endif

#include "cost/mixed_cost_kernel.h"

#include "cost/match_span.h"

#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "cost/mixed_cost_kernel.cc"
#include <hwy/foreach_target.h>
#include <hwy/highway.h>

#include "cost/cost_stretch-inl.h"
#include "cost/hamming-inl.h"

HWY_BEFORE_NAMESPACE();
namespace stereo_sgmp {
namespace HWY_NAMESPACE {
namespace hn = hwy::HWY_NAMESPACE;

using D8 = hn::CappedTag<std::uint8_t, VolumeShape::kPadding>;
using V8 = hn::Vec<D8>;

void SaturatedDifferencesOfRow(const std::uint8_t* after, const std::uint8_t* before, int width,
                               std::uint8_t* differences) {
  const D8 d;
  const hn::RebindToSigned<D8> ds;
  const V8 sign = hn::Set(d, std::uint8_t{0x80});
  for (int x = 0; x < width; x += static_cast<int>(hn::Lanes(d))) {
    // The sign bit flipped, both keep their difference as signed numbers.
    const auto a = hn::BitCast(ds, hn::Xor(hn::LoadU(d, after + x), sign));
    const auto b = hn::BitCast(ds, hn::Xor(hn::LoadU(d, before + x), sign));
    hn::StoreU(hn::BitCast(d, hn::SaturatedSub(a, b)), d, differences + x);
  }
}

// min(|a - b|, 127 or 128) of signed bytes: exact up to the limits of all terms.
HWY_INLINE V8 AbsoluteDifference(V8 a, V8 b) {
  const D8 d;
  const hn::RebindToSigned<D8> ds;
  const auto difference = hn::SaturatedSub(hn::BitCast(ds, a), hn::BitCast(ds, b));
  return hn::BitCast(d, hn::Abs(difference));  // the absolute value of -128 reads 128
}

// min(255, 7 h + floor(h / 4) + ad + 10 g) for h <= 34, ad <= 30, g <= 10 in bytes, as
// u + (u + ad - ceil(3 h / 4)) with u = 4 (h + g) + g <= 186: only the last sum can exceed 255.
HWY_INLINE V8 SumOfTerms(FullMixedCost /*cost*/, V8 h, V8 ad, V8 g) {
  const D8 d;
  const V8 t = hn::Add(h, g);
  const V8 t2 = hn::Add(t, t);
  const V8 u = hn::Add(hn::Add(t2, t2), g);
  // Two averages, which round up: ceil((ceil(h / 2) + h) / 2) = ceil(3 h / 4).
  const V8 three_quarters = hn::AverageRound(hn::AverageRound(h, hn::Zero(d)), h);
  return hn::SaturatedAdd(u, hn::Add(u, hn::Sub(ad, three_quarters)));
}

// min(36, h + g + ceil((ad + 3 g) / 8)): three averages, which round up, of ad, g, g and 2 (h + g)
// give ceil((ad + g + 2 g + 8 (h + g)) / 8).
HWY_INLINE V8 SumOfTerms(CompactMixedCost /*cost*/, V8 h, V8 ad, V8 g) {
  const D8 d;
  const V8 t = hn::Add(h, g);
  const V8 eighths = hn::AverageRound(hn::AverageRound(ad, g), g);
  return hn::Min(hn::AverageRound(eighths, hn::Add(t, t)),
                 hn::Set(d, std::uint8_t{CompactMixedCost::kMax}));
}

// Costs of single left pixels.
template <class Cost>
class MixedPixel {
 public:
  HWY_INLINE MixedPixel(FeatureRow left, FeatureRow right, const VolumeShape& shape,
                        std::uint8_t ad_limit)
      : left_(left),
        right_(right),
        first_match_(MirroredColumn(shape, 0)),
        limit_(hn::Set(D8(), ad_limit)) {}

  // At the disparity indices `inside`, rounded out to whole vectors.
  HWY_INLINE void operator()(int x, MatchSpan inside, std::uint8_t* costs) const {
    using F = MixedFeatures;
    const D8 d;
    const int lanes = static_cast<int>(hn::Lanes(d));
    const std::ptrdiff_t right = right_.distance;
    const V8 gradient_limit = hn::Set(d, std::uint8_t{10});
    // Read before costs are stored, which could change them for all the compiler knows.
    V8 census[F::kCensus.Bytes()];
    for (int i = 0; i < F::kCensus.Bytes(); ++i) census[i] = Left(x, i);
    const V8 gray = Left(x, F::kGray);
    const V8 gradient_x = Left(x, F::kGradientX);
    const V8 gradient_y = Left(x, F::kGradientY);
    const std::uint8_t* matches = right_.first + (first_match_ - x);
    for (int k = inside.begin & -lanes; k < inside.end; k += lanes) {
      const std::uint8_t* match = matches + k;
      const V8 h = HammingDistance(d, census, match, right);
      const V8 ad = AbsoluteDifference(gray, hn::LoadU(d, match + F::kGray * right));
      const V8 dx = AbsoluteDifference(gradient_x, hn::LoadU(d, match + F::kGradientX * right));
      const V8 dy = AbsoluteDifference(gradient_y, hn::LoadU(d, match + F::kGradientY * right));
      const V8 gradient = hn::Min(hn::SaturatedAdd(dx, dy), gradient_limit);
      hn::Store(SumOfTerms(Cost(), h, hn::Min(ad, limit_), gradient), d, costs + k);
    }
  }

 private:
  HWY_INLINE V8 Left(int x, int plane) const {
    return hn::Set(D8(), left_.first[x + plane * left_.distance]);
  }

  const FeatureRow left_;
  const FeatureRow right_;
  const std::ptrdiff_t first_match_;
  const V8 limit_;
};

template <class Cost>
HWY_INLINE void MixedStretch(FeatureRow left, FeatureRow right, const VolumeShape& shape,
                             std::uint8_t ad_limit, int x_begin, int x_end, std::uint8_t* costs) {
  const MixedPixel<Cost> pixel(left, right, shape, ad_limit);
  ComputeStretch(shape, x_begin, x_end, Cost::kOutside, pixel, costs);
}

void FullMixedStretch(FeatureRow left, FeatureRow right, const VolumeShape& shape,
                      std::uint8_t ad_limit, int x_begin, int x_end, std::uint8_t* costs) {
  MixedStretch<FullMixedCost>(left, right, shape, ad_limit, x_begin, x_end, costs);
}

void CompactMixedStretch(FeatureRow left, FeatureRow right, const VolumeShape& shape,
                         std::uint8_t ad_limit, int x_begin, int x_end, std::uint8_t* costs) {
  MixedStretch<CompactMixedCost>(left, right, shape, ad_limit, x_begin, x_end, costs);
}

}  // namespace HWY_NAMESPACE
}  // namespace stereo_sgmp
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace stereo_sgmp {

HWY_EXPORT(SaturatedDifferencesOfRow);
HWY_EXPORT(FullMixedStretch);
HWY_EXPORT(CompactMixedStretch);

void SaturatedDifferences(const std::uint8_t* after, const std::uint8_t* before, int width,
                          std::uint8_t* differences) {
  HWY_DYNAMIC_DISPATCH(SaturatedDifferencesOfRow)(after, before, width, differences);
}

void FullMixedCostRow(FeatureRow left, FeatureRow right, const VolumeShape& shape,
                      std::uint8_t ad_limit, int x_begin, int x_end, std::uint8_t* costs) {
  HWY_DYNAMIC_DISPATCH(FullMixedStretch)(left, right, shape, ad_limit, x_begin, x_end, costs);
}

void CompactMixedCostRow(FeatureRow left, FeatureRow right, const VolumeShape& shape,
                         std::uint8_t ad_limit, int x_begin, int x_end, std::uint8_t* costs) {
  HWY_DYNAMIC_DISPATCH(CompactMixedStretch)(left, right, shape, ad_limit, x_begin, x_end, costs);
}

}  // namespace stereo_sgmp
#endif  // HWY_ONCE
