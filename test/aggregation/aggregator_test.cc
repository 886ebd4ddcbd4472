#include "aggregation/aggregator.h"

#include <gtest/gtest.h>
#include <hwy/targets.h>

#include <atomic>
#include <chrono>
#include <cstring>
#include <optional>
#include <random>
#include <string>
#include <thread>
#include <utility>
#include <vector>

#include "aggregation/reference_aggregation.h"

namespace stereo_sgmp {
namespace {

// A volume of the reference as a cost source of the library.
class ReferenceCosts : public CostRows {
 public:
  explicit ReferenceCosts(const reference::Volume& volume) : volume_(volume) {}
  const VolumeShape& shape() const override { return volume_.shape; }
  int unit() const override { return volume_.unit; }
  const std::uint8_t* Row(int y, int x_begin, int x_end, std::uint8_t* scratch) const override {
    for (int x = x_begin; x < x_end; ++x) {
      for (int d = 0; d < volume_.shape.Stride(); ++d) {
        // What stands in the padding must not matter.
        const int cost = d < volume_.shape.disparities ? volume_.At(x, y, d) : (d * 7) % 3;
        scratch[(x - x_begin) * volume_.shape.Stride() + d] = static_cast<std::uint8_t>(cost);
      }
    }
    return scratch;
  }

 private:
  const reference::Volume& volume_;
};

// Costs whose first row is handed out when the backward sweep has come to the middle: so the
// forward sweep completes S of all rows below, however the threads run.
class LateFirstRow : public CostRows {
 public:
  explicit LateFirstRow(const CostRows& costs) : costs_(costs) {}
  const VolumeShape& shape() const override { return costs_.shape(); }
  int unit() const override { return costs_.unit(); }
  const std::uint8_t* Row(int y, int x_begin, int x_end, std::uint8_t* scratch) const override {
    if (y == (shape().height + 1) / 2) met_ = true;
    const auto end = std::chrono::steady_clock::now() + std::chrono::seconds(20);
    while (y == 0 && !met_ && std::chrono::steady_clock::now() < end) std::this_thread::yield();
    return costs_.Row(y, x_begin, x_end, scratch);
  }

  bool have_met() const { return met_; }

 private:
  const CostRows& costs_;
  mutable std::atomic<bool> met_{false};
};

// A prior given as a function.
class FunctionPrior : public OrientationPrior {
 public:
  FunctionPrior(VolumeShape shape, reference::JumpFunction jump)
      : shape_(shape), jump_(std::move(jump)) {}
  void Jumps(int y, int x_begin, int x_end, PathStep step, JumpRow* row) const override {
    row->Reset(static_cast<std::size_t>(x_end - x_begin));
    for (int x = x_begin; x < x_end; ++x) {
      const auto first = row->segments.size();
      for (int d = 0; d < shape_.disparities; ++d) {
        const int j = jump_(x, y, step, d);
        if (row->segments.size() == first || row->segments.back().jump != j) {
          row->segments.push_back({d, d, j});
        }
        row->segments.back().end = d + 1;
      }
      Point(static_cast<std::size_t>(x - x_begin), first, (x + y) % 2 == 0, row);
    }
  }

 private:
  // Sets a pixel whose segments are those from `first` on; with `as_cell` in the short form, where
  // one of them moves or all of them alike.
  static void Point(std::size_t entry, std::size_t first, bool as_cell, JumpRow* row) {
    JumpSegment moving;
    int count = 0;
    for (std::size_t i = first; i < row->segments.size(); ++i) {
      if (row->segments[i].jump == 0) continue;
      moving = row->segments[i];
      ++count;
    }
    const std::size_t segments = row->segments.size() - first;
    const bool is_cell = segments == 1 || (as_cell && count == 1);
    row->jump[entry] = is_cell ? static_cast<std::int16_t>(moving.jump) : JumpRow::kVaries;
    row->begin[entry] = static_cast<std::int16_t>(moving.begin);
    row->end[entry] = static_cast<std::int16_t>(moving.end);
    row->first_segment[entry] = static_cast<std::int32_t>(first);
    row->segment_count[entry] = static_cast<std::int16_t>(segments);
  }

  VolumeShape shape_;
  reference::JumpFunction jump_;
};

struct Case {
  int width;
  int height;
  int disparities;
  int min_disparity;
};

reference::Volume RandomVolume(const Case& size, unsigned seed, int unit = 1) {
  std::mt19937 random(seed);
  reference::Volume volume;
  volume.shape = {size.width, size.height, size.disparities, size.min_disparity};
  volume.costs.resize(static_cast<std::size_t>(size.width * size.height * size.disparities));
  // Few values, so that ties happen.
  for (std::uint8_t& cost : volume.costs) {
    cost = static_cast<std::uint8_t>(random() % 16 * 17 / static_cast<unsigned>(unit));
  }
  volume.unit = unit;
  return volume;
}

cv::Mat RandomGuide(const Case& size, int type, unsigned seed) {
  cv::Mat guide(size.height, size.width, type);
  cv::RNG random(seed);
  random.fill(guide, cv::RNG::UNIFORM, 0, 40);
  return guide;
}

// A hash of place and direction as the jump: some 0, some small, some beyond the padding.
int SomeJump(int x, int y, PathStep step, int band) {
  const unsigned hash =
      static_cast<unsigned>(x * 73 + y * 151 + step.dx * 31 + step.dy * 17 + band * 97 + 100000);
  const int kinds[] = {0, 1, -1, 3, -5, 0, 40, -70};
  return kinds[hash / 3 % 8];
}

void ExpectSame(const cv::Mat_<std::uint16_t>& got, const cv::Mat_<std::uint16_t>& expected,
                const char* name) {
  ASSERT_EQ(got.size(), expected.size());
  for (int y = 0; y < got.rows; ++y) {
    ASSERT_EQ(0, std::memcmp(got[y], expected[y],
                             sizeof(std::uint16_t) * static_cast<std::size_t>(got.cols)))
        << name << " differs in row " << y;
  }
}

void ExpectSame(const WinnerMap& got, const WinnerMap& expected) {
  ExpectSame(got.winner, expected.winner, "winner");
  ExpectSame(got.cost, expected.cost, "cost");
  ExpectSame(got.cost_below, expected.cost_below, "cost below");
  ExpectSame(got.cost_above, expected.cost_above, "cost above");
  ExpectSame(got.second, expected.second, "second");
  ExpectSame(got.uncertainty, expected.uncertainty, "uncertainty");
  ExpectSame(got.right_winner, expected.right_winner, "right winner");
}

constexpr Case kSizes[] = {{1, 1, 1, 0},    {1, 9, 2, 0},     {7, 1, 5, -2},    {5, 4, 31, 0},
                           {33, 6, 32, 0},  {40, 9, 33, 3},   {70, 5, 65, 0},   {65, 11, 20, -9},
                           {31, 8, 64, 40}, {3, 13, 130, 0},  {4, 5, 320, 0},   {3, 4, 400, 1},
                           {90, 4, 100, 2}, {140, 3, 140, 5}, {200, 1, 256, -3}};

// As many vectors as the longest and the shortest of them make of the usual ranges.
constexpr Case kWideSizes[] = {{190, 2, 180, -2}, {322, 2, 310, -4}, {321, 1, 320, 0}};

class AggregatorTest : public ::testing::Test {
 protected:
  WinnerMap Run(const reference::Volume& volume, const cv::Mat& guide,
                const reference::JumpFunction& jump, int slack, int threads) {
    ThreadPool pool(threads);
    const ReferenceCosts costs(volume);
    const FunctionPrior prior(volume.shape, jump);
    WinnerMap winners;
    aggregator_->Run(costs, guide, options_,
                     PathPrior{jump ? &prior : nullptr, jump ? &prior : nullptr, slack},
                     strip_rows_, &pool, &winners);
    return winners;
  }

  // With both sweeps completing S, which takes two rows for each.
  WinnerMap RunFromBothEnds(const reference::Volume& volume, const cv::Mat& guide,
                            const reference::JumpFunction& jump, int slack) {
    ThreadPool pool(2);
    const ReferenceCosts costs(volume);
    const LateFirstRow late(costs);
    const FunctionPrior prior(volume.shape, jump);
    WinnerMap winners;
    // A new one: buffers are those of the vector length that has filled them.
    Aggregator().Run(late, guide, options_, PathPrior{&prior, &prior, slack}, 0, &pool, &winners);
    EXPECT_TRUE(late.have_met());
    return winners;
  }

  void ExpectReference(const reference::JumpFunction& jump, int slack) {
    unsigned seed = 1;
    for (const Case& size : kSizes) ExpectReference(size, seed++, jump, slack, {kAllTargets});
  }

  template <class Sizes>
  void ExpectReferenceOnEachTarget(const Sizes& sizes, const reference::JumpFunction& jump,
                                   int slack) {
    const std::vector<std::int64_t> targets = hwy::SupportedAndGeneratedTargets();
    unsigned seed = 1;
    for (const Case& size : sizes) ExpectReference(size, seed++, jump, slack, targets);
  }

  AggregationOptions options_;
  int unit_ = 1;        // 1: path costs of 16 bits; kBytes: of 8
  int strip_rows_ = 0;  // all
  std::optional<Aggregator> aggregator_{std::in_place};

 private:
  static constexpr std::int64_t kAllTargets = 0;

  void ExpectReference(const Case& size, unsigned seed, const reference::JumpFunction& jump,
                       int slack, const std::vector<std::int64_t>& targets) {
    SCOPED_TRACE(::testing::Message() << size.width << "x" << size.height << "x" << size.disparities
                                      << " from " << size.min_disparity);
    const reference::Volume volume = RandomVolume(size, seed, unit_);
    const cv::Mat guide = RandomGuide(size, seed % 2 == 0 ? CV_8UC1 : CV_8UC3, seed);
    const WinnerMap expected = reference::Aggregate(volume, guide, options_, jump, slack);
    for (const std::int64_t target : targets) {
      SCOPED_TRACE(hwy::TargetName(target));
      hwy::SetSupportedTargetsForTest(target);
      if (target != kAllTargets) aggregator_.emplace();  // buffers are those of a target
      ExpectSame(Run(volume, guide, jump, slack, 1), expected);
      ExpectSame(Run(volume, guide, jump, slack, 3), expected);
    }
    hwy::SetSupportedTargetsForTest(kAllTargets);
  }
};

constexpr int kBytes = 7;

const reference::JumpFunction kOneJump = [](int x, int y, PathStep step, int) {
  return SomeJump(x, y, step, 0);
};
const reference::JumpFunction kSeveralJumps = [](int x, int y, PathStep step, int d) {
  return SomeJump(x, y, step, d / 11);
};

TEST_F(AggregatorTest, EqualsTheFormulasWithoutPrior) {
  for (const int unit : {1, kBytes}) {
    unit_ = unit;
    ExpectReference(nullptr, -1);
  }
}

TEST_F(AggregatorTest, EqualsTheFormulasWithA2dPrior) {
  for (const int unit : {1, kBytes}) {
    unit_ = unit;
    ExpectReference(kOneJump, -1);
    ExpectReference(kOneJump, 15);
  }
}

TEST_F(AggregatorTest, EqualsTheFormulasWithA3dPrior) {
  for (const int unit : {1, kBytes}) {
    unit_ = unit;
    ExpectReference(kSeveralJumps, -1);
    ExpectReference(kSeveralJumps, 15);
  }
}

TEST_F(AggregatorTest, EqualsTheFormulasWithFourPathsOnceAndTwice) {
  for (const PathScheme scheme : {PathScheme::kFour, PathScheme::kFourTwice}) {
    options_.scheme = scheme;
    for (const int unit : {1, kBytes}) {
      unit_ = unit;
      ExpectReference(nullptr, -1);
      ExpectReference(kSeveralJumps, 15);
    }
  }
}

TEST_F(AggregatorTest, EqualsTheFormulasInStrips) {
  for (const int unit : {1, kBytes}) {
    unit_ = unit;
    for (const int rows : {1, 4, 5}) {
      strip_rows_ = rows;
      ExpectReference(kSeveralJumps, 15);
    }
  }
  options_.scheme = PathScheme::kFourTwice;
  ExpectReference(kSeveralJumps, 15);
}

TEST_F(AggregatorTest, EverySimdTargetGivesTheSameBits) {
  for (const int unit : {1, kBytes}) {
    unit_ = unit;
    for (const PathScheme scheme :
         {PathScheme::kFour, PathScheme::kEight, PathScheme::kFourTwice}) {
      options_.scheme = scheme;
      ExpectReferenceOnEachTarget(kSizes, kSeveralJumps, 15);
    }
  }
}

TEST_F(AggregatorTest, EverySimdTargetGivesTheSameBitsInWideRanges) {
  for (const int unit : {1, kBytes}) {
    unit_ = unit;
    ExpectReferenceOnEachTarget(kWideSizes, kSeveralJumps, 15);
  }
}

TEST_F(AggregatorTest, BothSweepsCompleteSToTheSameBits) {
  for (const Case& size : {Case{33, 6, 32, 0}, Case{65, 11, 20, -9}, Case{31, 8, 64, 40},
                           Case{140, 4, 140, 5}, Case{200, 4, 256, -3}, Case{264, 4, 262, 0}}) {
    for (const int unit : {1, kBytes}) {
      for (const PathScheme scheme : {PathScheme::kEight, PathScheme::kFourTwice}) {
        SCOPED_TRACE(::testing::Message() << size.width << "x" << size.height << "x"
                                          << size.disparities << ", unit " << unit);
        options_.scheme = scheme;
        const reference::Volume volume = RandomVolume(size, 5, unit);
        const cv::Mat guide = RandomGuide(size, CV_8UC1, 5);
        const WinnerMap expected = reference::Aggregate(volume, guide, options_, kSeveralJumps, 15);
        for (const std::int64_t target : hwy::SupportedAndGeneratedTargets()) {
          SCOPED_TRACE(hwy::TargetName(target));
          hwy::SetSupportedTargetsForTest(target);
          ExpectSame(RunFromBothEnds(volume, guide, kSeveralJumps, 15), expected);
        }
        hwy::SetSupportedTargetsForTest(0);
      }
    }
  }
}

TEST_F(AggregatorTest, StripsKeepToTheLimitWhereAnyDo) {
  const VolumeShape shape{400, 900, 64, 0};
  constexpr int kThreads = 2;
  const auto memory = [&](int rows) {
    return Aggregator::Memory(shape, options_, kBytes, kThreads, rows);
  };
  EXPECT_EQ(Aggregator::StripRows(shape, options_, kBytes, kThreads, memory(0)), 0);
  const std::size_t limit = memory(0) / 2;
  const int rows = Aggregator::StripRows(shape, options_, kBytes, kThreads, limit);
  EXPECT_LE(memory(rows), limit);
  EXPECT_GT(memory(rows + 1), limit);
  const int fewest = Aggregator::StripRows(shape, options_, kBytes, kThreads, 1);
  for (int other = 1; other < shape.height; ++other) EXPECT_LE(memory(fewest), memory(other));
}

TEST_F(AggregatorTest, JumpsOfZeroChangeNothing) {
  const Case size{60, 20, 40, 0};
  const reference::Volume volume = RandomVolume(size, 5);
  const cv::Mat guide = RandomGuide(size, CV_8UC1, 5);
  const reference::JumpFunction zero = [](int, int, PathStep, int) { return 0; };
  ExpectSame(Run(volume, guide, zero, -1, 2), Run(volume, guide, nullptr, -1, 2));
}

TEST_F(AggregatorTest, MirroringTheVolumeMirrorsTheLeftResult) {
  const Case size{37, 19, 24, 0};
  const reference::Volume volume = RandomVolume(size, 6);
  reference::Volume turned = volume;
  const auto column = static_cast<std::size_t>(size.disparities);
  const std::size_t pixels = volume.costs.size() / column;
  for (std::size_t i = 0; i < pixels; ++i) {
    std::memcpy(&turned.costs[i * column], &volume.costs[(pixels - 1 - i) * column], column);
  }
  const cv::Mat guide = RandomGuide(size, CV_8UC3, 6);
  cv::Mat turned_guide;
  cv::flip(guide, turned_guide, -1);
  const WinnerMap straight = Run(volume, guide, nullptr, -1, 2);
  const WinnerMap mirrored = Run(turned, turned_guide, nullptr, -1, 2);
  cv::Mat_<std::uint16_t> back;
  cv::flip(mirrored.cost, back, -1);
  ExpectSame(back, straight.cost, "cost");
  cv::flip(mirrored.uncertainty, back, -1);
  ExpectSame(back, straight.uncertainty, "uncertainty");
}

TEST_F(AggregatorTest, TransposingTheVolumeTransposesTheLeftResult) {
  const Case size{29, 41, 24, 0};
  const reference::Volume volume = RandomVolume(size, 7);
  reference::Volume transposed = RandomVolume({size.height, size.width, size.disparities, 0}, 7);
  const auto column = static_cast<std::size_t>(size.disparities);
  for (int y = 0; y < size.height; ++y) {
    for (int x = 0; x < size.width; ++x) {
      const auto from = static_cast<std::size_t>(y * size.width + x) * column;
      const auto to = static_cast<std::size_t>(x * size.height + y) * column;
      std::memcpy(&transposed.costs[to], &volume.costs[from], column);
    }
  }
  const cv::Mat guide = RandomGuide(size, CV_8UC3, 7);
  const WinnerMap straight = Run(volume, guide, nullptr, -1, 2);
  const WinnerMap turned = Run(transposed, guide.t(), nullptr, -1, 2);
  ExpectSame(cv::Mat_<std::uint16_t>(turned.cost.t()), straight.cost, "cost");
  ExpectSame(cv::Mat_<std::uint16_t>(turned.uncertainty.t()), straight.uncertainty, "uncertainty");
}

TEST_F(AggregatorTest, ASlantedPlaneIsFreeWithItsOwnSurfaceAsPrior) {
  // C = 0 along round(S), 200 elsewhere; S has a slope that no constant disparity follows.
  const Case size{80, 40, 64, 0};
  const auto surface = [](int x, int y) { return static_cast<int>(0.45 * x + 0.3 * y + 5.5); };
  reference::Volume volume = RandomVolume(size, 1);
  for (int y = 0, i = 0; y < size.height; ++y) {
    for (int x = 0; x < size.width; ++x) {
      for (int d = 0; d < size.disparities; ++d, ++i) {
        volume.costs[static_cast<std::size_t>(i)] = d == surface(x, y) ? 0 : 200;
      }
    }
  }
  const reference::JumpFunction follow = [&](int x, int y, PathStep step, int) {
    return surface(x, y) - surface(x - step.dx, y - step.dy);
  };
  const WinnerMap winners = Run(volume, RandomGuide(size, CV_8UC1, 1), follow, -1, 2);
  for (int y = 0; y < size.height; ++y) {
    for (int x = 0; x < size.width; ++x) {
      ASSERT_EQ(winners.winner(y, x), surface(x, y));
      ASSERT_EQ(winners.cost(y, x), 0);
      ASSERT_EQ(winners.uncertainty(y, x), 0);
    }
  }
}

TEST_F(AggregatorTest, BuffersOfALargerVolumeServeASmallerOne) {
  const reference::Volume large = RandomVolume({50, 12, 100, 0}, 8);
  const Case size{50, 12, 90, 0};  // the same padded size
  const reference::Volume small = RandomVolume(size, 9);
  const cv::Mat guide = RandomGuide(size, CV_8UC1, 8);
  Run(large, guide, kOneJump, -1, 2);
  ExpectSame(Run(small, guide, kOneJump, -1, 2),
             reference::Aggregate(small, guide, options_, kOneJump, -1));
}

}  // namespace
}  // namespace stereo_sgmp
