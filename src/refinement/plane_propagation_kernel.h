#ifndef STEREO_SGMP_REFINEMENT_PLANE_PROPAGATION_KERNEL_H_
#define STEREO_SGMP_REFINEMENT_PLANE_PROPAGATION_KERNEL_H_

#include <array>
#include <cstddef>

namespace stereo_sgmp {

// Columns that stand side by side in memory, for PropagateDownColumns. All pointers point at the
// first column of the first row.
struct PropagationStrip {
  static constexpr int kWidth = 16;  // columns
  static constexpr int kSums = 5;    // n, x, xx, e and xe
  static constexpr int kMoments = 9;

  int height = 0;
  std::ptrdiff_t stride = 0;  // from row to row, of all images alike
  // Weighted sums over each row of 1, x, x^2, d and x d, with x counted from the pixel itself.
  std::array<const float*, kSums> sums{};
  const float* down = nullptr;   // link of each pixel to the one above
  const float* share = nullptr;  // of the way to the plane that the pixel moves
  float* disparity = nullptr;
  float* scratch = nullptr;  // ScratchSize(height) floats, aligned to 64 bytes

  static std::size_t ScratchSize(int height) {
    return static_cast<std::size_t>(height) * kMoments * kWidth;
  }
};

// Gathers the sums of the rows along the columns and moves each disparity towards the plane that
// they give (see PlanePropagation). Each pixel's sums are taken in the same order on any target.
void PropagateDownColumns(const PropagationStrip& strip);

}  // namespace stereo_sgmp

#endif  // STEREO_SGMP_REFINEMENT_PLANE_PROPAGATION_KERNEL_H_
