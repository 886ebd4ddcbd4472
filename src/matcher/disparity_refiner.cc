#include "matcher/disparity_refiner.h"

#include <algorithm>
#include <atomic>
#include <cstddef>
#include <cstdint>
#include <functional>
#include <iterator>
#include <mutex>

#include <opencv2/imgproc.hpp>

#include "refinement/confidence.h"
#include "refinement/fill.h"
#include "refinement/left_right.h"
#include "refinement/median.h"
#include "refinement/reason_counts.h"
#include "refinement/subpixel.h"
#include "refinement/validity.h"

namespace stereo_sgmp {
namespace {

// Superpixels of the refinement, in pixels of half the size: small enough to hold one surface each.
constexpr int kSuperpixelSize = 15;
constexpr double kCompactness = 10.0;

// Rows that go through all steps of a pass before the next ones do: few enough to stay in the
// second-level cache.
constexpr int kBlock = 16;

void CountReasons(const cv::Mat& reason, ThreadPool* pool, MatchStatistics* statistics) {
  std::fill(std::begin(statistics->reasons), std::end(statistics->reasons), 0);
  std::mutex mutex;
  pool->ForRanges(reason.rows, [&](int begin, int end) {
    ReasonCounts counts{};
    for (int y = begin; y < end; ++y) CountReasonsInRow(reason.ptr(y), reason.cols, &counts);
    const std::lock_guard<std::mutex> lock(mutex);
    for (std::size_t i = 0; i < counts.size(); ++i) statistics->reasons[i] += counts[i];
  });
  const double valid = statistics->reasons[static_cast<int>(InvalidReason::kValid)];
  statistics->density = valid / static_cast<double>(reason.total());
}

}  // namespace

void DisparityRefiner::Run(const WinnerMap& winners, const cv::Mat& image, const Options& options,
                           ThreadPool* pool, MatchResult* result) {
  const FilterOptions& filter = options.filter;
  cv::Mat& disparity = options.refinement.median ? filled_ : result->dense;
  ReadWinners(winners, options, pool, result, &disparity);
  if (options.refinement.superpixel_planes) {
    FillBySuperpixels(winners.shape, image, pool, &disparity);
  }
  Smooth(image, options.refinement, pool, result->confidence, &disparity);
  Filter(winners, options, pool, result);
  speckle_.Mark(result->dense, filter.speckle_size, filter.speckle_range, &result->reason, pool);
  CountReasons(result->reason, pool, &result->statistics);
}

// What can be said of a pixel from its winner and those around, and the disparities, with holes
// filled from their scanline if nothing else comes before that.
void DisparityRefiner::ReadWinners(const WinnerMap& winners, const Options& options,
                                   ThreadPool* pool, MatchResult* result, cv::Mat* disparity) {
  const cv::Size size = winners.winner.size();
  for (cv::Mat* map : {&result->raw, &result->uncertainty, &result->confidence, disparity}) {
    map->create(size, CV_32F);
  }
  left_right_.create(size, CV_16U);
  valid_.create(size, CV_8U);
  std::atomic<bool> all_filled{true};
  pool->ForPieces(size.height, kBlock, [&](int /*thread*/, int begin, int end) {
    RefineSubpixelRows(winners, options.refinement.subpixel, begin, end, &result->raw);
    UncertaintyImage(winners, begin, end, &result->uncertainty);
    LeftRightDifferences(winners, begin, end, &left_right_);
    ComputeConfidence(winners, left_right_, options.filter.confidence, options.aggregation, begin,
                      end, &result->confidence);
    FindAgreeing(options.filter.lr_tolerance, begin, end);
    cv::Mat rows = disparity->rowRange(begin, end);
    result->raw.rowRange(begin, end).copyTo(rows);
    if (!options.refinement.superpixel_planes && !FillRows(valid_, begin, end, disparity)) {
      all_filled = false;
    }
  });
  if (!all_filled) {
    FillEmptyRows(valid_, static_cast<float>(winners.shape.min_disparity), disparity);
  }
}

void DisparityRefiner::FindAgreeing(double tolerance, int begin, int end) {
  if (tolerance < 0.0) {
    valid_.rowRange(begin, end).setTo(255);
  } else {
    LeftRightMask(left_right_, static_cast<int>(tolerance) + 1, begin, end, &valid_);
  }
}

void DisparityRefiner::Smooth(const cv::Mat& image, const RefinementOptions& refinement,
                              ThreadPool* pool, const cv::Mat& confidence, cv::Mat* disparity) {
  if (refinement.weighted_median) {
    weighted_median_.Apply(image, confidence, *disparity, disparity, pool);
  }
  if (refinement.plane_propagation) propagation_.Apply(image, confidence, disparity, pool);
  if (refinement.plane_smoothing) {
    valid_.setTo(255);  // what was filled lies on a surface now
    smoother_.Smooth(image, valid_, disparity, pool);
  }
}

// The median, where it is asked for, and what is distrusted of the result.
void DisparityRefiner::Filter(const WinnerMap& winners, const Options& options, ThreadPool* pool,
                              MatchResult* result) {
  result->dense.create(winners.winner.size(), CV_32F);
  result->reason.create(winners.winner.size(), CV_8U);
  scratch_.resize(static_cast<std::size_t>(pool->size()));
  pool->ForPieces(result->dense.rows, kBlock, [&](int thread, int begin, int end) {
    if (options.refinement.median) {
      MedianOfRows(filled_, begin, end, &scratch_[static_cast<std::size_t>(thread)],
                   &result->dense);
    }
    FindInvalid(winners, left_right_, result->dense, result->confidence, options.filter, begin, end,
                &result->reason);
  });
}

void DisparityRefiner::FillBySuperpixels(const VolumeShape& shape, const cv::Mat& image,
                                         ThreadPool* pool, cv::Mat* disparity) {
  cv::resize(image, half_, SuperpixelPlanes::LabelSize(image.size()), 0.0, 0.0, cv::INTER_AREA);
  superpixels_.Segment(half_, kSuperpixelSize, kCompactness, pool);
  superpixel_planes_.Apply(superpixels_.labels(), superpixels_.count(), shape, disparity, &valid_,
                           pool);
  FillScanlines(valid_, static_cast<float>(shape.min_disparity), disparity, pool);
}

}  // namespace stereo_sgmp
