#ifndef STEREO_SGMP_COST_PATCH_STATISTICS_H_
#define STEREO_SGMP_COST_PATCH_STATISTICS_H_

#include <cstddef>
#include <cstdint>

#include "common/aligned_buffer.h"
#include "common/thread_pool.h"
#include "cost/padded_gray.h"

namespace stereo_sgmp {

inline constexpr int kPatchRadius = 2;
inline constexpr int kPatchPixels = (2 * kPatchRadius + 1) * (2 * kPatchRadius + 1);

// What normalised cross correlation needs to know of the 5x5 patches of one image, and the image
// in the form that its inner loop multiplies. Rows have room for whole vectors at both ends.
class PatchStatistics {
 public:
  static constexpr int kMargin = 64;

  void Compute(const PaddedGray& image, ThreadPool* pool);

  // Columns [-kMargin, width + kMargin) may be read, [-kPatchRadius, width + kPatchRadius) are
  // defined for Pairs and [0, width) for the others.

  // Two numbers of 16 bits in one of 32: I(x, y) below, I(x, y + 1) above, for y in
  // [-kPatchRadius, height + kPatchRadius).
  const std::int32_t* Pairs(int y) const { return pairs_.data() + Offset(y + kPatchRadius); }
  // Sum of the patch.
  const std::int32_t* Sums(int y) const { return sums_.data() + Offset(y); }
  // sqrt(25 sum I^2 - (sum I)^2): 25 times the standard deviation.
  const float* Deviations(int y) const { return deviations_.data() + Offset(y); }

  static std::size_t Bytes(int width, int height);

 private:
  std::size_t Offset(int row) const {
    return static_cast<std::size_t>(row) * stride_ + static_cast<std::size_t>(kMargin);
  }
  void PairRow(const PaddedGray& image, int y);

  std::size_t stride_ = 0;
  AlignedBuffer<std::int32_t> pairs_;
  AlignedBuffer<std::int32_t> sums_;
  AlignedBuffer<float> deviations_;
};

}  // namespace stereo_sgmp

#endif  // STEREO_SGMP_COST_PATCH_STATISTICS_H_
