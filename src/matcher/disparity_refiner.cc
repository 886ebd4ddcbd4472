#include "matcher/disparity_refiner.h"

#include <algorithm>

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

// 255 where the left and the right winner agree, which tells occlusions and blunders apart from
// the rest; everywhere if the check is off.
void LeftRightMask(const WinnerMap& winners, double tolerance, ThreadPool* pool, cv::Mat* mask) {
  mask->create(winners.winner.size(), CV_8U);
  if (tolerance < 0.0) {
    mask->setTo(255);
    return;
  }
  pool->ForRanges(mask->rows, [&](int begin, int end) {
    const int worst = static_cast<int>(tolerance) + 1;
    for (int y = begin; y < end; ++y) {
      const LeftRightRow row(winners, y);
      std::uint8_t* out = mask->ptr(y);
      for (int x = 0; x < mask->cols; ++x) out[x] = row.Difference(x, worst) < worst ? 255 : 0;
    }
  });
}

void CountReasons(const cv::Mat& reason, MatchStatistics* statistics) {
  std::fill(std::begin(statistics->reasons), std::end(statistics->reasons), 0);
  for (int y = 0; y < reason.rows; ++y) {
    const std::uint8_t* row = reason.ptr(y);
    for (int x = 0; x < reason.cols; ++x) ++statistics->reasons[row[x]];
  }
  const double valid = statistics->reasons[static_cast<int>(InvalidReason::kValid)];
  statistics->density = valid / static_cast<double>(reason.total());
}

}  // namespace

void DisparityRefiner::Run(const WinnerMap& winners, const cv::Mat& image, const Options& options,
                           ThreadPool* pool, MatchResult* result) {
  const FilterOptions& filter = options.filter;
  RefineSubpixel(winners, options.refinement.subpixel, &result->raw, pool);
  UncertaintyImage(winners, &result->uncertainty);
  ComputeConfidence(winners, filter.confidence, options.aggregation.p1, &result->confidence, pool);
  MakeDense(winners, image, options, pool, result);
  FindInvalid(winners, result->dense, result->confidence, filter, &result->reason, pool);
  speckle_.Mark(result->dense, filter.speckle_size, filter.speckle_range, &result->reason);
  CountReasons(result->reason, &result->statistics);
}

void DisparityRefiner::MakeDense(const WinnerMap& winners, const cv::Mat& image,
                                 const Options& options, ThreadPool* pool, MatchResult* result) {
  const RefinementOptions& refinement = options.refinement;
  LeftRightMask(winners, options.filter.lr_tolerance, pool, &valid_);
  cv::Mat& disparity = refinement.median ? filled_ : result->dense;
  result->raw.copyTo(disparity);
  FillHoles(winners.shape, image, refinement, pool, &disparity);
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
