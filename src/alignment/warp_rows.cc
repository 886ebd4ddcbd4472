#include "alignment/warp_rows.h"

#include <cstdint>

#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "alignment/warp_rows.cc"
#include <hwy/foreach_target.h>
#include <hwy/highway.h>

#ifndef STEREO_SGMP_ALIGNMENT_WARP_ROWS_TAPS_
#define STEREO_SGMP_ALIGNMENT_WARP_ROWS_TAPS_
namespace stereo_sgmp {

constexpr int kWeightBits = 7;
constexpr int kTaps = 4;

// One row as a weighted sum of four; the weights sum to 2^kWeightBits.
struct RowTaps {
  const std::uint8_t* rows[kTaps];
  std::int16_t weights[kTaps];
};

}  // namespace stereo_sgmp
#endif

HWY_BEFORE_NAMESPACE();
namespace stereo_sgmp {
namespace HWY_NAMESPACE {
namespace hn = hwy::HWY_NAMESPACE;

// Gray levels are taken relative to 128: sums of them then fit 16 bits, as |weights| sum to less
// than 256.
void BlendRows(const RowTaps& taps, int count, std::uint8_t* out) {
  const hn::ScalableTag<std::int16_t> d16;
  const hn::Rebind<std::uint8_t, decltype(d16)> d8;
  const int lanes = static_cast<int>(hn::Lanes(d16));
  const auto middle = hn::Set(d16, std::int16_t{128});
  const auto half = hn::Set(d16, std::int16_t{1 << (kWeightBits - 1)});
  int i = 0;
  for (; i + lanes <= count; i += lanes) {
    auto sum = half;
    for (int tap = 0; tap < kTaps; ++tap) {
      const auto gray = hn::PromoteTo(d16, hn::LoadU(d8, taps.rows[tap] + i));
      const auto weight = hn::Set(d16, taps.weights[tap]);
      sum = hn::Add(sum, hn::Mul(hn::Sub(gray, middle), weight));
    }
    const auto blended = hn::Add(hn::ShiftRight<kWeightBits>(sum), middle);
    hn::StoreU(hn::DemoteTo(d8, blended), d8, out + i);
  }
  for (; i < count; ++i) {
    int sum = 1 << (kWeightBits - 1);
    for (int tap = 0; tap < kTaps; ++tap) sum += taps.weights[tap] * (taps.rows[tap][i] - 128);
    out[i] = cv::saturate_cast<std::uint8_t>((sum >> kWeightBits) + 128);
  }
}

}  // namespace HWY_NAMESPACE
}  // namespace stereo_sgmp
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
#include <algorithm>
#include <cmath>

namespace stereo_sgmp {

HWY_EXPORT(BlendRows);

namespace {

// Cubic convolution with a = -1/2 at a distance t in [0, 2).
double CubicWeight(double t) {
  return t < 1.0 ? (1.5 * t - 2.5) * t * t + 1.0 : ((-0.5 * t + 2.5) * t - 4.0) * t + 2.0;
}

RowTaps TapsAt(const cv::Mat& image, double y) {
  // Far outside only the border is left; the clamp keeps the conversion to int defined.
  const double inside = std::clamp(y, -2.0, image.rows + 1.0);
  const double below = std::floor(inside);
  const double fraction = inside - below;
  RowTaps taps{};
  int sum = 0;
  for (int tap = 0; tap < kTaps; ++tap) {
    const int row = std::clamp(static_cast<int>(below) + tap - 1, 0, image.rows - 1);
    taps.rows[tap] = image.ptr<std::uint8_t>(row);
    const double weight = CubicWeight(std::abs(fraction + 1.0 - tap));
    taps.weights[tap] = static_cast<std::int16_t>(std::lround(weight * (1 << kWeightBits)));
    sum += taps.weights[tap];
  }
  // What rounding left over goes to the nearest row.
  std::int16_t& nearest = taps.weights[fraction < 0.5 ? 1 : 2];
  nearest = static_cast<std::int16_t>(nearest + (1 << kWeightBits) - sum);
  return taps;
}

}  // namespace

void WarpRows(const cv::Mat& image, double scale, double offset, cv::Mat* warped,
              ThreadPool* pool) {
  warped->create(image.size(), image.type());
  const int bytes = image.cols * static_cast<int>(image.elemSize());
  pool->ForRanges(image.rows, [&](int begin, int end) {
    for (int y = begin; y < end; ++y) {
      HWY_DYNAMIC_DISPATCH(BlendRows)
      (TapsAt(image, scale * y + offset), bytes, warped->ptr<std::uint8_t>(y));
    }
  });
}

}  // namespace stereo_sgmp
#endif  // HWY_ONCE
