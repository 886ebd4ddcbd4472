#include "stereo_sgmp/matcher.h"

#include <functional>
#include <optional>
#include <sstream>
#include <stdexcept>

#include "aggregation/aggregator.h"
#include "alignment/rig_alignment.h"
#include "alignment/warp_rows.h"
#include "cost/cost_computer.h"
#include "cost/kept_costs.h"
#include "cost/volume_cost.h"
#include "images/image_pair.h"
#include "matcher/coarse_pass.h"
#include "matcher/cost_keeping.h"
#include "matcher/disparity_refiner.h"
#include "matcher/memory.h"
#include "matcher/path_unit.h"
#include "matcher/prior_stage.h"
#include "matcher/seen_range.h"
#include "matcher/stage_clock.h"
#include "stereo_sgmp/option_fields.h"

namespace stereo_sgmp {
namespace {

void CheckRange(const Options& options, cv::Size size) {
  if (options.num_disparities <= size.width) return;
  std::ostringstream text;
  text << "num_disparities is " << options.num_disparities << ", but the images are only "
       << size.width << " pixels wide; set it to " << size.width << " or less";
  throw std::invalid_argument(text.str());
}

// Whether the disparities that the coarse pass sees are all that is searched: not where costs or a
// prior are given, which may know of others.
bool SearchesSeenRange(const Options& options, const MatchInputs& inputs) {
  if (!options.narrow_range || inputs.costs != nullptr) return false;
  if (options.num_disparities <= SeenRange::kBlock) return false;
  switch (options.prior.variant) {
    case Variant::kSgm:
    case Variant::kEpi:
    case Variant::kEpv:
    case Variant::kMw:
      return true;
    case Variant::kGs:
    case Variant::kGp:
    case Variant::kGni:
    case Variant::kGnv:
      return false;
  }
  return false;
}

// For planes, for the radiometric fit of the mixed cost, or for the range.
bool NeedsCoarsePass(const Options& options, const MatchInputs& inputs) {
  return options.prior.variant != Variant::kSgm || options.cost.kind == CostKind::kMixed ||
         SearchesSeenRange(options, inputs);
}

}  // namespace

class Matcher::Impl {
 public:
  explicit Impl(const Options& options) { SetOptions(options); }

  void SetOptions(const Options& options) {
    CheckOptions(options);
    if (!pool_ || options.threads != options_.threads ||
        options.pin_threads != options_.pin_threads) {
      pool_ = std::make_unique<ThreadPool>(options.threads, options.pin_threads);
    }
    options_ = options;
  }

  const Options& options() const { return options_; }

  void Match(const cv::Mat& left, const cv::Mat& right, const MatchInputs& inputs,
             MatchResult* result) {
    StageClock clock(&result->statistics);
    images_.Prepare(left, right);
    const cv::Size size = images_.size();
    CheckRange(options_, size);
    CheckInputs(options_.prior.variant, inputs, size);
    VolumeShape shape{size.width, size.height, options_.num_disparities, options_.min_disparity};
    std::optional<VolumeCost> given_costs;
    if (inputs.costs != nullptr)
      given_costs.emplace(*inputs.costs, shape, PathUnit(options_, true));
    CheckMemory(options_, size, inputs, held_);
    held_ = EstimateMemory(options_, size, inputs);
    clock.Mark("images");

    result->statistics.alignment = AlignRows();
    clock.Mark("alignment");

    if (NeedsCoarsePass(options_, inputs)) coarse_.Run(options_, images_, pool_.get());
    if (SearchesSeenRange(options_, inputs)) {
      shape = seen_range_.Find(coarse_.disparity(), shape, pool_.get());
    }
    result->statistics.searched_disparities = shape.disparities;
    clock.Mark("coarse pass");
    const CostRows* costs = given_costs ? &*given_costs : nullptr;
    const SideWork prepare_costs = PrepareCosts(shape, &costs);
    const PathPrior prior =
        prior_.Make(options_.prior, inputs, images_, coarse_, shape, pool_.get(),
                    given_costs ? nullptr : &prepare_costs, &result->priors);
    result->statistics.planes = static_cast<int>(result->priors.planes.size());
    clock.Mark("prior");

    if (costs == nullptr) {
      costs = &StartCosts(shape);
      costs_.PrepareLeft(pool_.get());
      costs_.PrepareRight(pool_.get());
    }
    if (!given_costs) costs_.Complete(pool_.get());
    clock.Mark("cost");
    const cv::Mat& guide =
        options_.aggregation.color_guide ? images_.left_color() : images_.left_gray();
    aggregator_.Run(*costs, guide, options_.aggregation, prior, StripRows(options_, shape, inputs),
                    pool_.get(), &winners_);
    clock.Mark("aggregation");
    refiner_.Run(winners_, images_.left_color(), options_, pool_.get(), result);
    clock.Mark("refinement");
    clock.Finish();
  }

  void ResetRig() { alignment_.Reset(); }

 private:
  AlignmentReport AlignRows() {
    const AlignmentReport report =
        alignment_.Update(options_.alignment, images_.left_gray(), images_.right_gray(),
                          options_.min_disparity, options_.num_disparities);
    if (report.applied) {
      WarpRows(images_.right_gray(), report.scale, report.offset, &warped_, pool_.get());
      cv::swap(images_.right_gray(), warped_);
    }
    return report;
  }

  // Beside the planes of a prior; sets `costs`.
  SideWork PrepareCosts(const VolumeShape& shape, const CostRows** costs) {
    return {[this, &shape, costs] { *costs = &StartCosts(shape); },
            {[this] { costs_.PrepareLeft(&left_alone_); },
             [this] { costs_.PrepareRight(&right_alone_); }},
            [this, costs](const std::function<bool()>& have_planes) {
              if (*costs == &kept_costs_) {
                kept_costs_.ComputeAhead(have_planes);
              } else {
                costs_.ComputeAhead(have_planes);
              }
            }};
  }

  const CostRows& StartCosts(const VolumeShape& shape) {
    const CostRows& costs =
        costs_.Start(options_.cost, images_.left_gray(), images_.right_gray(), shape,
                     coarse_.FitRadiometry(options_.cost.kind), PathUnit(options_, false));
    if (!KeepsCosts(options_, shape)) return costs;
    kept_costs_.Start(costs);
    return kept_costs_;
  }

  Options options_;
  std::unique_ptr<ThreadPool> pool_;
  ThreadPool left_alone_{1};  // for what one thread of the other does alone with an image
  ThreadPool right_alone_{1};
  std::size_t held_ = 0;  // bytes of the buffers of the last frame
  ImagePair images_;
  RigAlignment alignment_;
  cv::Mat warped_;
  CoarsePass coarse_;
  SeenRange seen_range_;
  PriorStage prior_;
  CostComputer costs_;
  KeptCosts kept_costs_;
  Aggregator aggregator_;
  WinnerMap winners_;
  DisparityRefiner refiner_;
};

Matcher::Matcher(const Options& options) : impl_(std::make_unique<Impl>(options)) {}
Matcher::~Matcher() = default;

void Matcher::SetOptions(const Options& options) { impl_->SetOptions(options); }
const Options& Matcher::options() const { return impl_->options(); }

void Matcher::Match(const cv::Mat& left, const cv::Mat& right, MatchResult* result) {
  impl_->Match(left, right, MatchInputs(), result);
}

void Matcher::Match(const cv::Mat& left, const cv::Mat& right, const MatchInputs& inputs,
                    MatchResult* result) {
  impl_->Match(left, right, inputs, result);
}

void Matcher::ResetRig() { impl_->ResetRig(); }

}  // namespace stereo_sgmp
