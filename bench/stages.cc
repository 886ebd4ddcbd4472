#include "stages.h"

#include <map>
#include <utility>

#include "aggregation/aggregator.h"
#include "alignment/rig_alignment.h"
#include "alignment/warp_rows.h"
#include "common/aligned_buffer.h"
#include "common/thread_pool.h"
#include "cost/cost_computer.h"
#include "cost/radiometric_fit.h"
#include "images/image_pair.h"
#include "matcher/coarse_pass.h"
#include "matcher/disparity_refiner.h"
#include "matcher/path_unit.h"
#include "matcher/prior_stage.h"

namespace stereo_sgmp {
namespace {

Options StageOptions(const BenchPair& pair, int threads) {
  Options options;
  options.num_disparities = pair.disparities;
  options.threads = threads;
  return options;
}

// A frame in the steps of Matcher, any of which can be repeated on what those before it left.
class Pipeline {
 public:
  Pipeline(const BenchPair& pair, int threads)
      : pair_(pair),
        options_(StageOptions(pair, threads)),
        shape_{pair.left.cols, pair.left.rows, pair.disparities, options_.min_disparity},
        pool_(threads) {
    Images();
    Coarse();
    epi_prior_ = EpiPrior();
    epv_prior_ = EpvPrior();
    PrepareCost();
    AggregateAlongPlanes();
  }

  void Images() { images_.Prepare(pair_.left, pair_.right); }

  // What the first frames of a rig do, one after the other.
  void LearnRig() {
    RigAlignment alignment;
    alignment.Update(options_.alignment, images_.left_gray(), images_.right_gray(),
                     options_.min_disparity, options_.num_disparities);
  }

  // What each frame of a rig with a residual does.
  void Warp() { WarpRows(images_.right_gray(), 1.001, 0.3, &warped_, &pool_); }

  void Coarse() {
    coarse_.Run(options_, images_, &pool_);
    fit_ = coarse_.FitRadiometry(options_.cost.kind);
  }

  // One plane for each pixel, without the copies that would make it a 3D prior.
  PathPrior EpiPrior() { return MakePrior(Variant::kEpi, 0.0, &epi_stage_); }
  PathPrior EpvPrior() { return MakePrior(Variant::kEpv, options_.prior.attraction, &epv_stage_); }

  void PrepareCost() {
    costs_ = &computer_.Prepare(options_.cost, images_.left_gray(), images_.right_gray(), shape_,
                                fit_, PathUnit(options_, false), &pool_);
  }

  // All costs once, as a sweep asks for them, without using them.
  void Cost() {
    PrepareCost();
    constexpr int kStretch = 32;
    pool_.ForRanges(shape_.height, [&](int begin, int end) {
      AlignedBuffer<std::uint8_t> scratch;
      scratch.Resize(static_cast<std::size_t>(kStretch * shape_.Stride()));
      for (int y = begin; y < end; ++y) {
        for (int x = 0; x < shape_.width; x += kStretch) {
          costs_->Row(y, x, std::min(x + kStretch, shape_.width), scratch.data());
        }
      }
    });
  }

  // With the costs, which it asks for.
  void AggregateWithoutPrior() { Aggregate({}); }
  void AggregateAlongOffsetImage() { Aggregate(epi_prior_); }
  void AggregateAlongPlanes() { Aggregate(epv_prior_); }

  void Refine() { refiner_.Run(winners_, images_.left_color(), options_, &pool_, &result_); }

 private:
  PathPrior MakePrior(Variant variant, double attraction, PriorStage* stage) {
    PriorOptions options = options_.prior;
    options.variant = variant;
    options.attraction = attraction;
    return stage->Make(options, MatchInputs(), images_, coarse_, shape_, &pool_, nullptr, &report_);
  }

  void Aggregate(const PathPrior& prior) {
    aggregator_.Run(*costs_, images_.left_color(), options_.aggregation, prior, 0, &pool_,
                    &winners_);
  }

  const BenchPair& pair_;
  Options options_;
  VolumeShape shape_;
  ThreadPool pool_;
  ImagePair images_;
  cv::Mat warped_;
  CoarsePass coarse_;
  RadiometricFit fit_;
  PriorStage epi_stage_;
  PriorStage epv_stage_;
  PathPrior epi_prior_;
  PathPrior epv_prior_;
  PlanePriors report_;
  CostComputer computer_;
  const CostRows* costs_ = nullptr;
  Aggregator aggregator_;
  WinnerMap winners_;
  DisparityRefiner refiner_;
  MatchResult result_;
};

// The stages of one pair and number of threads share a pipeline while any of them lives.
std::shared_ptr<Pipeline> SharedPipeline(const BenchPair& pair, int threads) {
  static std::map<std::pair<const BenchPair*, int>, std::weak_ptr<Pipeline>> pipelines;
  std::weak_ptr<Pipeline>& known = pipelines[{&pair, threads}];
  std::shared_ptr<Pipeline> pipeline = known.lock();
  if (!pipeline) {
    pipeline = std::make_shared<Pipeline>(pair, threads);
    known = pipeline;
  }
  return pipeline;
}

class Stage : public Subject {
 public:
  using Step = std::function<void(Pipeline*)>;
  Stage(std::shared_ptr<Pipeline> pipeline, Step step)
      : pipeline_(std::move(pipeline)), step_(std::move(step)) {}
  void Run() override { step_(pipeline_.get()); }

 private:
  std::shared_ptr<Pipeline> pipeline_;
  Step step_;
};

}  // namespace

std::vector<SubjectEntry> StageSubjects() {
  const std::pair<const char*, Stage::Step> stages[] = {
      {"images", [](Pipeline* p) { p->Images(); }},
      {"alignment_fit", [](Pipeline* p) { p->LearnRig(); }},
      {"alignment_warp", [](Pipeline* p) { p->Warp(); }},
      {"coarse_pass", [](Pipeline* p) { p->Coarse(); }},
      {"prior_epi", [](Pipeline* p) { p->EpiPrior(); }},
      {"prior_epv", [](Pipeline* p) { p->EpvPrior(); }},
      {"cost", [](Pipeline* p) { p->Cost(); }},
      {"aggregation_none", [](Pipeline* p) { p->AggregateWithoutPrior(); }},
      {"aggregation_offset_image", [](Pipeline* p) { p->AggregateAlongOffsetImage(); }},
      {"aggregation_3d_prior", [](Pipeline* p) { p->AggregateAlongPlanes(); }},
      {"refinement", [](Pipeline* p) { p->Refine(); }},
  };
  std::vector<SubjectEntry> subjects;
  for (const auto& [name, step] : stages) {
    const auto make = [step = step](const BenchPair& pair, int threads) {
      return std::make_unique<Stage>(SharedPipeline(pair, threads), step);
    };
    subjects.push_back({std::string("stage/") + name, make});
  }
  return subjects;
}

}  // namespace stereo_sgmp
