#include "matcher/disparity_refiner.h"

#include <algorithm>
#include <iterator>
#include <mutex>

#include <opencv2/imgproc.hpp>

#include "refinement/confidence.h"
#include "refinement/fill.h"
#include "refinement/left_right.h"
#include "refinement/subpixel.h"
#include "refinement/validity.h"

namespace stereo_sgmp {
namespace {

// Superpixels of the refinement, in pixels of half the size: small enough to hold one surface each.
constexpr int kSuperpixelSize = 15;
constexpr double kCompactness = 10.0;

// The pixels of each reason in a row, added to `counts`. Several counters in turn, since a counter
// would wait for its last increment where neighbours are alike.
void CountRow(const std::uint8_t* row, int width, int (&counts)[kInvalidReasonCount]) {
  constexpr int kLanes = 4;
  int lanes[kLanes][kInvalidReasonCount] = {};
  for (int x = 0; x < width; ++x) ++lanes[x % kLanes][row[x]];
  for (const auto& lane : lanes) {
    for (int reason = 0; reason < kInvalidReasonCount; ++reason) counts[reason] += lane[reason];
  }
}

void CountReasons(const cv::Mat& reason, ThreadPool* pool, MatchStatistics* statistics) {
  std::fill(std::begin(statistics->reasons), std::end(statistics->reasons), 0);
  std::mutex mutex;
  pool->ForRanges(reason.rows, [&](int begin, int end) {
    int counts[kInvalidReasonCount] = {};
    for (int y = begin; y < end; ++y) CountRow(reason.ptr(y), reason.cols, counts);
    const std::lock_guard<std::mutex> lock(mutex);
    for (int i = 0; i < kInvalidReasonCount; ++i) statistics->reasons[i] += counts[i];
  });
  const double valid = statistics->reasons[static_cast<int>(InvalidReason::kValid)];
  statistics->density = valid / static_cast<double>(reason.total());
}

}  // namespace

void DisparityRefiner::Run(const WinnerMap& winners, const cv::Mat& image, const Options& options,
                           ThreadPool* pool, MatchResult* result) {
  const FilterOptions& filter = options.filter;
  RefineSubpixel(winners, options.refinement.subpixel, &result->raw, pool);
  UncertaintyImage(winners, &result->uncertainty);
  LeftRightDifferences(winners, &left_right_, pool);
  ComputeConfidence(winners, left_right_, filter.confidence, options.aggregation.p1,
                    &result->confidence, pool);
  MakeDense(winners.shape, image, options, pool, result);
  FindInvalid(winners, left_right_, result->dense, result->confidence, filter, &result->reason,
              pool);
  speckle_.Mark(result->dense, filter.speckle_size, filter.speckle_range, &result->reason, pool);
  CountReasons(result->reason, pool, &result->statistics);
}

void DisparityRefiner::FindAgreeing(double tolerance, ThreadPool* pool) {
  if (tolerance < 0.0) {
    valid_.create(left_right_.size(), CV_8U);
    valid_.setTo(255);
    return;
  }
  LeftRightMask(left_right_, static_cast<int>(tolerance) + 1, &valid_, pool);
}

void DisparityRefiner::MakeDense(const VolumeShape& shape, const cv::Mat& image,
                                 const Options& options, ThreadPool* pool, MatchResult* result) {
  const RefinementOptions& refinement = options.refinement;
  FindAgreeing(options.filter.lr_tolerance, pool);
  cv::Mat& disparity = refinement.median ? filled_ : result->dense;
  result->raw.copyTo(disparity);
  FillHoles(shape, image, refinement, pool, &disparity);
  if (refinement.weighted_median) {
    weighted_median_.Apply(image, result->confidence, disparity, &disparity, pool);
  }
  if (refinement.plane_propagation) {
    propagation_.Apply(image, result->confidence, &disparity, pool);
  }
  if (refinement.plane_smoothing) {
    valid_.setTo(255);  // what was filled lies on a surface now
    smoother_.Smooth(image, valid_, &disparity, pool);
  }
  if (refinement.median) median_.Apply(filled_, &result->dense, pool);
}

void DisparityRefiner::FillHoles(const VolumeShape& shape, const cv::Mat& image,
                                 const RefinementOptions& refinement, ThreadPool* pool,
                                 cv::Mat* disparity) {
  if (refinement.superpixel_planes) {
    cv::resize(image, half_, SuperpixelPlanes::LabelSize(image.size()), 0.0, 0.0, cv::INTER_AREA);
    superpixels_.Segment(half_, kSuperpixelSize, kCompactness, pool);
    superpixel_planes_.Apply(superpixels_.labels(), superpixels_.count(), shape, disparity, &valid_,
                             pool);
  }
  FillScanlines(valid_, static_cast<float>(shape.min_disparity), disparity, pool);
}

}  // namespace stereo_sgmp
