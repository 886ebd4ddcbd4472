#include "prior/estimated_prior.h"

#include <atomic>
#include <cstddef>
#include <cstdint>
#include <functional>
#include <utility>
#include <vector>

#include "prior/nearest_planes.h"

namespace stereo_sgmp {
namespace {

// Weight of distance against colour (8-bit CIELAB) in superpixels: high enough that they stay
// compact where the image has little texture, which is where the prior is needed.
constexpr double kCompactness = 20.0;

// One set per plane, so that a label is a set.
void SetsOfLabels(const cv::Mat& labels, std::size_t planes, PlaneSets* sets) {
  sets->sets.assign(planes + 1, PlaneSet());
  for (std::size_t i = 0; i < planes; ++i) {
    sets->sets[i + 1].count = 1;
    sets->sets[i + 1].planes[0] = static_cast<std::int16_t>(i);
  }
  labels.convertTo(sets->ids, CV_16U, 1.0, 1.0);
}

// What threads do for one prior, where a job waits for none but those that it needs.
class Jobs {
 public:
  std::size_t Add(std::function<void()> work, std::vector<std::size_t> after = {}) {
    jobs_.push_back({std::move(work), std::move(after)});
    return jobs_.size() - 1;
  }

  void Add(const SideWork& beside, const std::atomic<bool>& have_planes) {
    const std::size_t first = Add(beside.first);
    std::vector<std::size_t> parts;
    for (const std::function<void()>& part : beside.parts) parts.push_back(Add(part, {first}));
    Add([&beside, &have_planes] { beside.last([&] { return have_planes.load(); }); },
        std::move(parts));
  }

  // In their order where there are no threads.
  void Run(ThreadPool* threads) const {
    if (threads != nullptr) return threads->RunJobs(jobs_);
    for (const ThreadPool::Job& job : jobs_) job.work();
  }

 private:
  std::vector<ThreadPool::Job> jobs_;
};

}  // namespace

const OrientationPrior* EstimatedPrior::Estimate(const PriorOptions& options,
                                                 const CoarseDisparity& coarse,
                                                 const cv::Mat& coarse_left,
                                                 const VolumeShape& full, ThreadPool* threads,
                                                 const SideWork* beside) {
  report_.planes.clear();
  if (options.variant == Variant::kSgm) {
    report_.labels.release();
    return nullptr;
  }
  const PlaneSets& sets = options.variant == Variant::kEpi
                              ? SpreadOverSuperpixels(options, coarse, coarse_left, threads, beside)
                              : SpreadOverHulls(options, coarse, coarse_left, threads, beside);
  ScaleUp(CoarseScale::Between({full.width, full.height}, coarse.disparity.size()));
  steering_.Assign(options, full_planes_, sets, full);
  return steering_.attracting();
}

void EstimatedPrior::FindPlanes(const PriorOptions& options, const CoarseDisparity& coarse,
                                std::atomic<bool>* have_planes) {
  hypotheses_.Find(coarse, SmallestPlane(options, coarse.disparity.size()), nullptr);
  *have_planes = true;
}

void EstimatedPrior::ScaleUp(const CoarseScale& scale) {
  full_planes_.clear();
  for (const CoarsePlane& coarse : hypotheses_.map().planes) {
    full_planes_.push_back(scale.ToFull(coarse.plane));
    report_.planes.push_back({full_planes_.back(), coarse.area, coarse.rms * scale.x});
  }
}

const PlaneSets& EstimatedPrior::SpreadOverSuperpixels(const PriorOptions& options,
                                                       const CoarseDisparity& coarse,
                                                       const cv::Mat& coarse_left,
                                                       ThreadPool* threads,
                                                       const SideWork* beside) {
  std::atomic<bool> have_planes{false};
  Jobs jobs;
  const std::size_t find = jobs.Add([&] { FindPlanes(options, coarse, &have_planes); });
  const std::size_t segment = jobs.Add(
      [&] { superpixels_.Segment(coarse_left, options.superpixel_size, kCompactness, nullptr); });
  if (beside != nullptr) jobs.Add(*beside, have_planes);
  jobs.Add([&] { modal_.Assign(hypotheses_.map(), superpixels_, options.min_support); },
           {find, segment});
  if (options.spread) {
    const std::size_t spread = jobs.Add([&] { SpreadLabels(coarse_left); }, {find});
    jobs.Add([&] { spread_modal_.Assign(spread_, superpixels_, 0.0); }, {segment, spread});
  }
  jobs.Run(threads);
  modal_.labels().copyTo(report_.labels);
  if (options.spread) {
    cv::compare(report_.labels, 0, unlabelled_, cv::CMP_LT);
    spread_modal_.labels().copyTo(report_.labels, unlabelled_);
  }
  SetsOfLabels(report_.labels, hypotheses_.map().planes.size(), &modal_sets_);
  return modal_sets_;
}

const PlaneSets& EstimatedPrior::SpreadOverHulls(const PriorOptions& options,
                                                 const CoarseDisparity& coarse,
                                                 const cv::Mat& coarse_left, ThreadPool* threads,
                                                 const SideWork* beside) {
  std::atomic<bool> have_planes{false};
  Jobs jobs;
  const std::size_t find = jobs.Add([&] { FindPlanes(options, coarse, &have_planes); });
  if (beside != nullptr) jobs.Add(*beside, have_planes);
  jobs.Add([&] { hulls_.Build(hypotheses_.map()); }, {find});
  if (options.spread) jobs.Add([&] { SpreadLabels(coarse_left); }, {find});
  jobs.Run(threads);
  if (options.spread) hulls_.FillEmpty(spread_.labels);
  coarse_planes_.clear();
  for (const CoarsePlane& plane : hypotheses_.map().planes) coarse_planes_.push_back(plane.plane);
  LabelNearestPlanes(hulls_.sets(), coarse_planes_, coarse.disparity, &report_.labels, threads);
  return hulls_.sets();
}

void EstimatedPrior::SpreadLabels(const cv::Mat& coarse_left) {
  spread_.planes = hypotheses_.map().planes;
  hypotheses_.map().labels.copyTo(spread_.labels);
  spreader_.Spread(coarse_left, &spread_.labels);
}

}  // namespace stereo_sgmp
