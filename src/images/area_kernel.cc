#include "images/area_kernel.h"

#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "images/area_kernel.cc"
#include <hwy/foreach_target.h>
#include <hwy/highway.h>

#include <cstddef>

HWY_BEFORE_NAMESPACE();
namespace stereo_sgmp {
namespace HWY_NAMESPACE {
namespace hn = hwy::HWY_NAMESPACE;

// kTaps: their number if it is known, else 0.
template <int kTaps>
void SumTapsOfGray(const float* source, const std::vector<int>& first, const float* weight,
                   int taps, float* shrunk) {
  if (kTaps != 0) taps = kTaps;
  for (const int column : first) {
    const float* const tap = source + column;
    float sum = 0.0F;
    for (int k = 0; k < taps; ++k) sum += tap[k] * weight[k];
    *shrunk++ = sum;
    weight += taps;
  }
}

// The three channels of a pixel are lanes of a vector, whose fourth is not used.
template <int kTaps>
void SumTapsOfColor(const float* source, const std::vector<int>& first, const float* weight,
                    int taps, float* shrunk) {
  constexpr int kChannels = 3;
  const hn::CappedTag<float, kChannels + kTapOverrun> d;
  const int lanes = static_cast<int>(hn::Lanes(d));
  if (kTaps != 0) taps = kTaps;
  for (const int column : first) {
    const float* const tap = source + static_cast<std::ptrdiff_t>(column) * kChannels;
    for (int c = 0; c < kChannels; c += lanes) {
      auto sum = hn::Zero(d);
      for (int k = 0; k < taps; ++k) {
        const auto value = hn::LoadU(d, tap + k * kChannels + c);
        sum = hn::Add(sum, hn::Mul(value, hn::Set(d, weight[k])));
      }
      hn::StoreU(sum, d, shrunk + c);
    }
    shrunk += kChannels;
    weight += taps;
  }
}

template <int kTaps>
void SumTapsOf(const float* source, int channels, const std::vector<int>& first,
               const float* weights, int taps, float* shrunk) {
  if (channels == 1) {
    SumTapsOfGray<kTaps>(source, first, weights, taps, shrunk);
  } else {
    SumTapsOfColor<kTaps>(source, first, weights, taps, shrunk);
  }
}

// Unrolled for the usual numbers of taps, those of factors from 2 to 4.
void SumTapsOnTarget(const float* source, int channels, const std::vector<int>& first,
                     const float* weights, int taps, float* shrunk) {
  switch (taps) {
    case 3:
      return SumTapsOf<3>(source, channels, first, weights, taps, shrunk);
    case 4:
      return SumTapsOf<4>(source, channels, first, weights, taps, shrunk);
    case 5:
      return SumTapsOf<5>(source, channels, first, weights, taps, shrunk);
    default:
      return SumTapsOf<0>(source, channels, first, weights, taps, shrunk);
  }
}

void AddWeightedOnTarget(const float* values, float weight, int count, float* sums) {
  const hn::ScalableTag<float> d;
  const int lanes = static_cast<int>(hn::Lanes(d));
  int i = 0;
  for (; i + lanes <= count; i += lanes) {
    const auto product = hn::Mul(hn::Set(d, weight), hn::LoadU(d, values + i));
    hn::StoreU(hn::Add(hn::LoadU(d, sums + i), product), d, sums + i);
  }
  for (; i < count; ++i) sums[i] += weight * values[i];
}

void BytesToFloatsOnTarget(const std::uint8_t* bytes, int count, float* floats) {
  const hn::ScalableTag<float> d;
  const hn::Rebind<std::int32_t, decltype(d)> di;
  const hn::Rebind<std::uint8_t, decltype(d)> d8;
  const int lanes = static_cast<int>(hn::Lanes(d));
  int i = 0;
  for (; i + lanes <= count; i += lanes) {
    hn::StoreU(hn::ConvertTo(d, hn::PromoteTo(di, hn::LoadU(d8, bytes + i))), d, floats + i);
  }
  for (; i < count; ++i) floats[i] = static_cast<float>(bytes[i]);
}

}  // namespace HWY_NAMESPACE
}  // namespace stereo_sgmp
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace stereo_sgmp {

HWY_EXPORT(SumTapsOnTarget);
HWY_EXPORT(AddWeightedOnTarget);
HWY_EXPORT(BytesToFloatsOnTarget);

void SumTaps(const float* source, int channels, const std::vector<int>& first, const float* weights,
             int taps, float* shrunk) {
  HWY_DYNAMIC_DISPATCH(SumTapsOnTarget)(source, channels, first, weights, taps, shrunk);
}

void AddWeighted(const float* values, float weight, int count, float* sums) {
  HWY_DYNAMIC_DISPATCH(AddWeightedOnTarget)(values, weight, count, sums);
}

void BytesToFloats(const std::uint8_t* bytes, int count, float* floats) {
  HWY_DYNAMIC_DISPATCH(BytesToFloatsOnTarget)(bytes, count, floats);
}

}  // namespace stereo_sgmp
#endif  // HWY_ONCE
