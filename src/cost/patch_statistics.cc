#include "cost/patch_statistics.h"

#include <algorithm>
#include <cmath>

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
    for (int y = begin; y < end; ++y) StatisticsRow(image, y);
    const int first = begin == 0 ? -kPatchRadius : begin;
    const int last = end == image.height() ? end + kPatchRadius : end;
    for (int y = first; y < last; ++y) PairRow(image, y);
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

void PatchStatistics::StatisticsRow(const PaddedGray& image, int y) {
  const std::uint8_t* rows[2 * kPatchRadius + 1];
  for (int dy = -kPatchRadius; dy <= kPatchRadius; ++dy) {
    rows[dy + kPatchRadius] = image.Row(y + dy);
  }
  const auto add_column = [&rows](int x, int sign, int* sum, int* squares) {
    for (const std::uint8_t* row : rows) {
      *sum += sign * row[x];
      *squares += sign * row[x] * row[x];
    }
  };
  std::int32_t* sums = sums_.data() + Offset(y);
  float* deviations = deviations_.data() + Offset(y);
  int sum = 0;
  int squares = 0;
  for (int x = -kPatchRadius; x < kPatchRadius; ++x) add_column(x, 1, &sum, &squares);
  for (int x = 0; x < image.width(); ++x) {
    add_column(x + kPatchRadius, 1, &sum, &squares);
    sums[x] = sum;
    deviations[x] = std::sqrt(static_cast<float>(kPatchPixels * squares - sum * sum));
    add_column(x - kPatchRadius, -1, &sum, &squares);
  }
}

std::size_t PatchStatistics::Bytes(int width, int height) {
  const std::size_t rows = static_cast<std::size_t>(height);
  return StrideOf(width) * (sizeof(std::int32_t) * (rows + 2 * kPatchRadius) +
                            (sizeof(std::int32_t) + sizeof(float)) * rows);
}

}  // namespace stereo_sgmp
