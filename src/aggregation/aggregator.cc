#include "aggregation/aggregator.h"

#include "aggregation/contrast.h"
#include "aggregation/penalties.h"
#include "aggregation/sweep.h"
#include "common/aligned_buffer.h"

namespace stereo_sgmp {
namespace {

// The sharpened costs between the two rounds of PathScheme::kFourTwice.
class SharpenedCosts : public CostRows {
 public:
  SharpenedCosts(const VolumeShape& shape, const std::uint8_t* volume)
      : shape_(shape), volume_(volume) {}

  const VolumeShape& shape() const override { return shape_; }
  const std::uint8_t* Row(int y, int x_begin, int, std::uint8_t*) const override {
    const std::ptrdiff_t pixel = static_cast<std::ptrdiff_t>(y) * shape_.width + x_begin;
    return volume_ + pixel * shape_.Stride();
  }

 private:
  VolumeShape shape_;
  const std::uint8_t* volume_;
};

}  // namespace

class Aggregator::Impl {
 public:
  void Run(const CostRows& costs, const cv::Mat& guide, const AggregationOptions& options,
           const PathPrior& prior, ThreadPool* pool, WinnerMap* winners) {
    const VolumeShape& shape = costs.shape();
    const Penalties penalties(options);
    winners->Create(shape);
    contrast_.Compute(guide, pool);
    sum_.Resize(shape.PaddedSize());
    minimum_sum_.Resize(shape.PaddedSize() / static_cast<std::size_t>(shape.Stride()));

    SweepJob job;
    job.costs = &costs;
    job.contrast = &contrast_;
    job.penalties = &penalties;
    job.prior = prior.first_round;
    job.jump_slack = prior.jump_slack;
    job.sum = sum_.data();
    job.minimum_sum = minimum_sum_.data();
    job.winners = winners;
    if (options.scheme == PathScheme::kEight) {
      RunRound(job, SweepKind::kLast, pool);
      return;
    }
    job.paths = 2;
    sharpened_.Resize(shape.PaddedSize());
    job.sharpened = sharpened_.data();
    RunRound(job, SweepKind::kSharpen, pool);
    const SharpenedCosts sharpened(shape, sharpened_.data());
    job.costs = &sharpened;
    job.prior = prior.last_round;
    RunRound(job, SweepKind::kLast, pool);
  }

 private:
  // A forward and a backward sweep; the latter ends as `last` says.
  void RunRound(SweepJob job, SweepKind last, ThreadPool* pool) {
    job.kind = SweepKind::kFirst;
    job.backward = false;
    sweep_.Run(job, pool);
    job.kind = last;
    job.backward = true;
    sweep_.Run(job, pool);
  }

  Contrast contrast_;
  Sweep sweep_;
  AlignedBuffer<std::uint16_t> sum_;
  AlignedBuffer<std::uint16_t> minimum_sum_;
  AlignedBuffer<std::uint8_t> sharpened_;
};

Aggregator::Aggregator() : impl_(std::make_unique<Impl>()) {}
Aggregator::~Aggregator() = default;

void Aggregator::Run(const CostRows& costs, const cv::Mat& guide, const AggregationOptions& options,
                     const PathPrior& prior, ThreadPool* pool, WinnerMap* winners) {
  impl_->Run(costs, guide, options, prior, pool, winners);
}

std::size_t Aggregator::Memory(const VolumeShape& shape, PathScheme scheme, int threads) {
  const std::size_t pixels = shape.PaddedSize() / static_cast<std::size_t>(shape.Stride());
  const std::size_t sharpened = scheme == PathScheme::kFourTwice ? shape.PaddedSize() : 0;
  constexpr std::size_t kWinnerMapBytes = 7 * sizeof(std::uint16_t);
  return shape.PaddedSize() * sizeof(std::uint16_t) + sharpened +
         pixels * (sizeof(std::uint16_t) + kPathsPerSweep + kWinnerMapBytes) +
         Sweep::Memory(shape, threads);
}

}  // namespace stereo_sgmp
