#include "aggregation/aggregator.h"

#include <algorithm>
#include <array>
#include <cstdint>
#include <vector>

#include "aggregation/contrast.h"
#include "aggregation/penalties.h"
#include "aggregation/row_strips.h"
#include "aggregation/sweep_pair.h"
#include "common/aligned_buffer.h"
#include "cost/cost_unit.h"

namespace stereo_sgmp {
namespace {

// The sharpened costs between the two rounds of PathScheme::kFourTwice.
class SharpenedCosts : public CostRows {
 public:
  SharpenedCosts(const CostRows& costs, const std::uint8_t* volume)
      : shape_(costs.shape()), unit_(costs.unit()), volume_(volume) {}

  const VolumeShape& shape() const override { return shape_; }
  int unit() const override { return unit_; }
  const std::uint8_t* Row(int y, int x_begin, int, std::uint8_t*) const override {
    return volume_ + shape_.Offset(y, x_begin);
  }

 private:
  VolumeShape shape_;
  int unit_;
  const std::uint8_t* volume_;
};

// Whether C + P2, and with it every path cost, fits 8 bits.
bool FitBytes(const Penalties& penalties, int unit) {
  constexpr int kLargest = 255;
  const int p2 = *std::max_element(penalties.p2.begin(), penalties.p2.end());
  return CompactCost(kLargest, unit) + p2 <= kLargest;
}

template <class T>
std::size_t MemoryOf(const VolumeShape& shape, PathScheme scheme, int threads, int strip_rows) {
  const auto stride = static_cast<std::size_t>(shape.Stride());
  const std::size_t pixels = shape.PaddedSize() / stride;
  const RowStrips strips(shape.height, strip_rows);
  const std::size_t sum = static_cast<std::size_t>(strips.rows()) *
                          static_cast<std::size_t>(shape.width) * stride * sizeof(T);
  const auto lines = static_cast<std::size_t>(strips.Count() > 1 ? strips.Count() + 1 : 0);
  const std::size_t sharpened = scheme == PathScheme::kFourTwice ? shape.PaddedSize() : 0;
  constexpr std::size_t kWinnerMapBytes = 7 * sizeof(std::uint16_t);
  return sum + lines * StateLineBuffer<T>::Bytes(shape.width, shape.Stride()) + sharpened +
         pixels * (sizeof(std::uint16_t) + kPathsPerSweep + kWinnerMapBytes) +
         SweepPair<T>::Memory(shape, threads);
}

// Rounds of sweeps with messages of type T.
template <class T>
class Rounds {
 public:
  // A forward and a backward sweep over all rows; what they sum up ends as `completion` says.
  void Run(SweepJob<T> job, SweepKind completion, const RowStrips& strips, ThreadPool* pool) {
    sum_.Resize(static_cast<std::size_t>(strips.rows()) *
                (job.costs->shape().PaddedSize() / static_cast<std::size_t>(strips.height())));
    job.sum = sum_.data();
    SaveCheckpoints(job, strips, pool);
    for (int strip = strips.Count(); strip-- > 0;) {
      job.begin = strips.Begin(strip);
      job.end = strips.End(strip);
      const auto parity = static_cast<std::size_t>(strip % 2);
      sweeps_.Run(job, completion, Checkpoint(strip),
                  job.end < strips.height() ? &backward_[1 - parity] : nullptr,
                  strip > 0 ? &backward_[parity] : nullptr, pool);
    }
  }

 private:
  // The messages of the forward sweep from each strip to the next.
  void SaveCheckpoints(SweepJob<T> job, const RowStrips& strips, ThreadPool* pool) {
    checkpoints_.resize(static_cast<std::size_t>(strips.Count() - 1));
    for (int strip = 0; strip + 1 < strips.Count(); ++strip) {
      job.begin = strips.Begin(strip);
      job.end = strips.End(strip);
      sweeps_.RunStates(job, Checkpoint(strip), &checkpoints_[static_cast<std::size_t>(strip)],
                        pool);
    }
  }

  StateLineBuffer<T>* Checkpoint(int strip) {
    return strip > 0 ? &checkpoints_[static_cast<std::size_t>(strip) - 1] : nullptr;
  }

  SweepPair<T> sweeps_;
  AlignedBuffer<T> sum_;  // of the rows of a strip
  std::vector<StateLineBuffer<T>> checkpoints_;
  std::array<StateLineBuffer<T>, 2> backward_;
};

}  // namespace

class Aggregator::Impl {
 public:
  void Run(const CostRows& costs, const cv::Mat& guide, const AggregationOptions& options,
           const PathPrior& prior, int strip_rows, ThreadPool* pool, WinnerMap* winners) {
    const RowStrips strips(costs.shape().height, strip_rows);
    const Penalties penalties(options, prior.jump_slack, costs.unit());
    if (FitBytes(penalties, costs.unit())) {
      RunRounds(costs, guide, options, prior, penalties, strips, pool, &rounds8_, winners);
    } else {
      RunRounds(costs, guide, options, prior, penalties, strips, pool, &rounds16_, winners);
    }
  }

 private:
  template <class T>
  void RunRounds(const CostRows& costs, const cv::Mat& guide, const AggregationOptions& options,
                 const PathPrior& prior, const Penalties& penalties, const RowStrips& strips,
                 ThreadPool* pool, Rounds<T>* rounds, WinnerMap* winners) {
    const VolumeShape& shape = costs.shape();
    winners->Create(shape);
    contrast_.Compute(guide, pool);
    minimum_sum_.Resize(shape.PaddedSize() / static_cast<std::size_t>(shape.Stride()));

    SweepJob<T> job;
    job.costs = &costs;
    job.contrast = &contrast_;
    job.penalties = &penalties;
    job.prior = prior.first_round;
    job.minimum_sum = minimum_sum_.data();
    job.winners = winners;
    if (options.scheme != PathScheme::kEight) job.paths = 2;
    if (options.scheme != PathScheme::kFourTwice) {
      rounds->Run(job, SweepKind::kLast, strips, pool);
      return;
    }
    sharpened_.Resize(shape.PaddedSize());
    job.sharpened = sharpened_.data();
    rounds->Run(job, SweepKind::kSharpen, strips, pool);
    const SharpenedCosts sharpened(costs, sharpened_.data());
    job.costs = &sharpened;
    job.prior = prior.last_round;
    rounds->Run(job, SweepKind::kLast, strips, pool);
  }

  Contrast contrast_;
  Rounds<std::uint8_t> rounds8_;
  Rounds<std::uint16_t> rounds16_;
  AlignedBuffer<std::uint16_t> minimum_sum_;
  AlignedBuffer<std::uint8_t> sharpened_;
};

Aggregator::Aggregator() : impl_(std::make_unique<Impl>()) {}
Aggregator::~Aggregator() = default;

void Aggregator::Run(const CostRows& costs, const cv::Mat& guide, const AggregationOptions& options,
                     const PathPrior& prior, int strip_rows, ThreadPool* pool, WinnerMap* winners) {
  impl_->Run(costs, guide, options, prior, strip_rows, pool, winners);
}

std::size_t Aggregator::Memory(const VolumeShape& shape, const AggregationOptions& options,
                               int unit, int threads, int strip_rows) {
  return FitBytes(Penalties(options, -1, unit), unit)
             ? MemoryOf<std::uint8_t>(shape, options.scheme, threads, strip_rows)
             : MemoryOf<std::uint16_t>(shape, options.scheme, threads, strip_rows);
}

int Aggregator::StripRows(const VolumeShape& shape, const AggregationOptions& options, int unit,
                          int threads, std::size_t limit) {
  const auto memory = [&](int rows) { return Memory(shape, options, unit, threads, rows); };
  if (memory(0) <= limit) return 0;
  // Higher strips need more for S and less for the messages between strips, and repeat less: the
  // highest that fit are right.
  int best = 1;
  for (int rows = 1; rows < shape.height; ++rows) {
    if (memory(rows) <= limit || memory(rows) < memory(best)) best = rows;
  }
  return best;
}

}  // namespace stereo_sgmp
