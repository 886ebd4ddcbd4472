#ifndef STEREO_SGMP_REFINEMENT_WEIGHTED_MEDIAN_KERNEL_H_
#define STEREO_SGMP_REFINEMENT_WEIGHTED_MEDIAN_KERNEL_H_

#include <cstddef>
#include <cstdint>

namespace stereo_sgmp {

inline constexpr int kMedianRadius = 3;

// Pixels that the kernel may read beyond the end of a row, apart from the radius: one vector.
inline constexpr int kMedianOverhang = 16;

// What the weighted medians of one row are taken of. All pointers point at pixel 0 of the row
// within images that are readable kMedianRadius pixels around, and kMedianOverhang more to the
// right.
struct MedianRow {
  const float* disparity = nullptr;
  const std::uint8_t* confidence = nullptr;  // factor of a pixel's weight
  const std::uint8_t* channels[3] = {};
  int channel_count = 0;                       // 1 or 3
  std::ptrdiff_t stride = 0;                   // from row to row, of all images alike
  const std::int32_t* color_weight = nullptr;  // of each of the 256 differences: at most 65535
};

// Writes the `width` weighted medians of the row (see WeightedMedianFilter). Weights are integers
// whose sums stay below 2^30, so that no order of summation and no SIMD target changes them.
void WeightedMedianRow(const MedianRow& row, int width, float* filtered);

}  // namespace stereo_sgmp

#endif  // STEREO_SGMP_REFINEMENT_WEIGHTED_MEDIAN_KERNEL_H_
