#ifndef STEREO_SGMP_REFINEMENT_PLANE_SMOOTHING_KERNEL_H_
#define STEREO_SGMP_REFINEMENT_PLANE_SMOOTHING_KERNEL_H_

#include <cstddef>
#include <cstdint>

namespace stereo_sgmp {

inline constexpr int kSmoothingRadius = 4;
inline constexpr int kSmoothingStep = 2;  // of the window only every second pixel and row is taken

// Pixels that the kernel may touch beyond the end of a row, apart from the radius: one vector.
inline constexpr int kSmoothingOverhang = 16;

// Disparity of a pixel that takes no part. Far from any other, yet finite: times 0 it is 0.
inline constexpr float kMissingDisparity = 1e30f;

// What the planes around the pixels of one row are fitted to. All pointers point at pixel 0 of
// the row within images that are readable kSmoothingRadius pixels around, and kSmoothingOverhang
// more to the right.
struct SmoothingRow {
  const float* disparity = nullptr;  // kMissingDisparity where it is not valid
  const std::uint8_t* channels[3] = {};
  int channel_count = 0;          // 1 or 3
  std::ptrdiff_t stride = 0;      // from row to row, of disparity and channels alike
  const float* weight = nullptr;  // of each of the 256 largest channel differences
};

// Moves the `width` values of `disparity` to the planes fitted around them (see PlaneSmoother).
// Each pixel's sums are taken in the same order on any SIMD target: along dx, then dy.
void SmoothPlaneRow(const SmoothingRow& row, int width, float* disparity);

}  // namespace stereo_sgmp

#endif  // STEREO_SGMP_REFINEMENT_PLANE_SMOOTHING_KERNEL_H_
