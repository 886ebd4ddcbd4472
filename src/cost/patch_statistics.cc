#include "cost/patch_statistics.h"

#include "cost/patch_statistics_kernel.h"

namespace stereo_sgmp {
namespace {

std::size_t StrideOf(int width) {
  return static_cast<std::size_t>(width) + 2 * PatchStatistics::kMargin;
}

}  // namespace

void PatchStatistics::Compute(const PaddedGray& image, ThreadPool* pool) {
  const std::size_t rows = static_cast<std::size_t>(image.height());
  stride_ = StrideOf(image.width());
  pairs_.Resize(stride_ * (rows + 2 * kPatchRadius));
  sums_.Resize(stride_ * rows);
  deviations_.Resize(stride_ * rows);
  pool->ForRanges(image.height(), [&](int begin, int end) {
    const int first = begin == 0 ? -kPatchRadius : begin;
    const int last = end == image.height() ? end + kPatchRadius : end;
    for (int y = first; y < last; ++y) PairRow(image, y);
  });
  pool->ForRanges(image.height(), [&](int begin, int end) {
    for (int y = begin; y < end; ++y) {
      SumPatches({Pairs(y - kPatchRadius), Pairs(y), Pairs(y + kPatchRadius)}, image.width(),
                 sums_.data() + Offset(y), deviations_.data() + Offset(y));
    }
  });
}

void PatchStatistics::PairRow(const PaddedGray& image, int y) {
  const std::uint8_t* row = image.Row(y);
  const std::uint8_t* next = image.Row(y + 1);
  std::int32_t* pairs = pairs_.data() + Offset(y + kPatchRadius);
  for (int x = -kPatchRadius; x < image.width() + kPatchRadius; ++x) {
    pairs[x] = row[x] | next[x] << 16;
  }
}

std::size_t PatchStatistics::Bytes(int width, int height) {
  const std::size_t rows = static_cast<std::size_t>(height);
  return StrideOf(width) * (sizeof(std::int32_t) * (rows + 2 * kPatchRadius) +
                            (sizeof(std::int32_t) + sizeof(float)) * rows);
}

}  // namespace stereo_sgmp
