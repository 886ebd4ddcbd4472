#include "cost/kept_costs.h"

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <vector>

#include <gtest/gtest.h>

#include "common/aligned_buffer.h"

namespace stereo_sgmp {
namespace {

// Costs that differ everywhere; counts how often each row is computed, in pixels.
class CountingCosts : public CostRows {
 public:
  explicit CountingCosts(const VolumeShape& shape, bool is_stored = false)
      : pixels(static_cast<std::size_t>(shape.height)), shape_(shape), is_stored_(is_stored) {
    stored_.Resize(shape.PaddedSize());
    for (std::size_t i = 0; i < stored_.size(); ++i) {
      stored_[i] = static_cast<std::uint8_t>(i * 7 + i / 251);
    }
  }

  const VolumeShape& shape() const override { return shape_; }
  int unit() const override { return 7; }
  const std::uint8_t* Row(int y, int x_begin, int x_end, std::uint8_t* scratch) const override {
    pixels[static_cast<std::size_t>(y)] += x_end - x_begin;
    const std::uint8_t* first = stored_.data() + shape_.Offset(y, x_begin);
    if (is_stored_) return first;
    std::copy(first, stored_.data() + shape_.Offset(y, x_end), scratch);
    return scratch;
  }

  std::uint8_t At(int y, int x, int k) const {
    return stored_[shape_.Offset(y, x) + static_cast<std::size_t>(k)];
  }

  mutable std::vector<int> pixels;

 private:
  VolumeShape shape_;
  bool is_stored_;
  AlignedBuffer<std::uint8_t> stored_;
};

const VolumeShape kShape{37, 5, 70, 0};

// Asks for [x_begin, x_end) of a row and compares all that comes.
void ExpectRow(const KeptCosts& kept, const CountingCosts& source, int y, int x_begin, int x_end) {
  AlignedBuffer<std::uint8_t> scratch;
  scratch.Resize(static_cast<std::size_t>((x_end - x_begin) * kShape.Stride()));
  const std::uint8_t* row = kept.Row(y, x_begin, x_end, scratch.data());
  for (int x = x_begin; x < x_end; ++x) {
    for (int k = 0; k < kShape.disparities; ++k) {
      ASSERT_EQ(row[(x - x_begin) * kShape.Stride() + k], source.At(y, x, k))
          << "row " << y << ", pixel " << x << ", index " << k;
    }
  }
}

// As sweeps do, whose stretches begin at different pixels.
void ExpectForward(const KeptCosts& kept, const CountingCosts& source, int y) {
  for (int x = 0; x < kShape.width; x += 16) {
    ExpectRow(kept, source, y, x, std::min(x + 16, kShape.width));
  }
}

void ExpectBackward(const KeptCosts& kept, const CountingCosts& source, int y) {
  for (int end = kShape.width; end > 0; end -= 16) {
    ExpectRow(kept, source, y, std::max(0, end - 16), end);
  }
}

// The two from both ends, until they have met and passed.
void ExpectBothSweeps(const KeptCosts& kept, const CountingCosts& source) {
  const int meeting = kShape.height / 2;
  for (int y = 0; y < meeting; ++y) ExpectForward(kept, source, y);
  for (int y = kShape.height; y-- > meeting;) ExpectBackward(kept, source, y);
  for (int y = meeting; y < kShape.height; ++y) ExpectForward(kept, source, y);
  for (int y = meeting; y-- > 0;) ExpectBackward(kept, source, y);
}

TEST(KeptCostsTest, TwoSweepsComputeEachCostOnce) {
  for (const bool is_stored : {false, true}) {
    const CountingCosts source(kShape, is_stored);
    KeptCosts kept;
    kept.Start(source);
    EXPECT_EQ(kept.unit(), 7);
    ExpectBothSweeps(kept, source);
    EXPECT_EQ(source.pixels, std::vector<int>(5, kShape.width));
  }
}

TEST(KeptCostsTest, WhatIsComputedAheadIsNotComputedAgain) {
  for (const int rows : {0, 2, 5, 9}) {
    SCOPED_TRACE(rows);
    const CountingCosts source(kShape);
    KeptCosts kept;
    kept.Start(source);
    int asked = 0;
    kept.ComputeAhead([&] { return asked++ == rows; });
    std::vector<int> ahead(5, 0);
    std::fill_n(ahead.begin(), std::min(rows, kShape.height), kShape.width);
    EXPECT_EQ(source.pixels, ahead);
    ExpectBothSweeps(kept, source);
    EXPECT_EQ(source.pixels, std::vector<int>(5, kShape.width));
  }
}

TEST(KeptCostsTest, PartsInAnyOrderAreRight) {
  const CountingCosts source(kShape);
  KeptCosts kept;
  kept.Start(source);
  ExpectRow(kept, source, 2, 20, 30);
  ExpectRow(kept, source, 2, 0, 25);
  ExpectRow(kept, source, 2, 10, 37);
  ExpectBothSweeps(kept, source);
}

TEST(KeptCostsTest, ANewSourceIsComputedAnew) {
  KeptCosts kept;
  const CountingCosts before(kShape);
  kept.Start(before);
  kept.ComputeAhead([] { return false; });
  VolumeShape higher = kShape;
  higher.height = 9;
  const CountingCosts source(higher);
  kept.Start(source);
  ExpectRow(kept, source, 8, 0, kShape.width);
  ExpectBothSweeps(kept, source);
  EXPECT_EQ(source.pixels[0], kShape.width);
}

}  // namespace
}  // namespace stereo_sgmp
