#ifndef STEREO_SGMP_PRIOR_PLANE_SEED_KERNEL_H_
#define STEREO_SGMP_PRIOR_PLANE_SEED_KERNEL_H_

#include <array>

namespace stereo_sgmp {

// Half width of the window a seed plane is fitted to, coarse pixels.
constexpr int kSeedRadius = 5;
// Distance of the windows' centres in x and y.
constexpr int kSeedStep = 3;

// Windows that are fitted at once.
constexpr int kSeedBatch = 16;
// Disparities that are read beyond the last window of a batch.
constexpr int kSeedOverrun = kSeedStep * kSeedBatch + 2 * kSeedRadius;

// The planes of kSeedBatch windows of a row.
struct SeedBatch {
  // Residual of the window, more for missing pixels: low = good. Infinite where too much is
  // missing.
  std::array<double, kSeedBatch> rank;
  // d = a x + b y + c relative to the centre, and to its disparity.
  std::array<double, kSeedBatch> a;
  std::array<double, kSeedBatch> b;
  std::array<double, kSeedBatch> c;
};

// Fits a plane by least squares to the disparities near that of the centre, in windows whose
// centres lie at `centre` and each kSeedStep further. Rows lie `stride` apart; disparities that are
// not numbers are missing.
void FitSeeds(const float* centre, int stride, SeedBatch* seeds);

}  // namespace stereo_sgmp

#endif  // STEREO_SGMP_PRIOR_PLANE_SEED_KERNEL_H_
