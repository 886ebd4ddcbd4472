#include "matcher/coarse_pass.h"

#include <algorithm>
#include <cmath>

#include "matcher/cost_keeping.h"
#include "matcher/path_unit.h"
#include "refinement/subpixel.h"

namespace stereo_sgmp {
namespace {

// The paper's coarse images are a quarter of the full ones each way. A quarter of a small image
// shows too little of its planes; more pixels than this show no more of them.
constexpr double kCoarsePixels = 0.12e6;

int CoarseFactor(int factor, cv::Size full) {
  if (factor > 0) return factor;
  const double pixels = static_cast<double>(full.width) * full.height;
  return std::clamp(static_cast<int>(std::ceil(std::sqrt(pixels / kCoarsePixels))), 2, 4);
}

int Shrunk(int length, int factor) {
  return std::max(1, static_cast<int>(std::lround(static_cast<double>(length) / factor)));
}

}  // namespace

VolumeShape CoarsePass::Shape(const Options& options, cv::Size full) {
  const int factor = CoarseFactor(options.prior.coarse_factor, full);
  VolumeShape shape;
  shape.width = Shrunk(full.width, factor);
  shape.height = Shrunk(full.height, factor);
  const double ratio = static_cast<double>(shape.width) / full.width;
  const int last = options.min_disparity + options.num_disparities - 1;
  shape.min_disparity = static_cast<int>(std::floor(options.min_disparity * ratio));
  // None beyond the range: ranges are mostly multiples of SIMD vectors, and stay so.
  shape.disparities =
      std::max(1, static_cast<int>(std::floor(last * ratio)) - shape.min_disparity + 1);
  return shape;
}

void CoarsePass::Run(const Options& options, const ImagePair& full, ThreadPool* pool) {
  const VolumeShape shape = Shape(options, full.size());
  images_.Shrink(full, {shape.width, shape.height}, pool);
  // The exposures of the two images are not known yet: absolute differences would mislead.
  RadiometricFit unknown;
  unknown.ad_weight = 0.0;
  const CostRows* costs = &costs_.Prepare(options.cost, images_.left_gray(), images_.right_gray(),
                                          shape, unknown, PathUnit(options, false), pool);
  if (KeepsCosts(options, shape)) {
    kept_costs_.Start(*costs);
    costs = &kept_costs_;
  }
  AggregationOptions aggregation = options.aggregation;
  aggregation.scheme = PathScheme::kEight;
  const cv::Mat& guide = aggregation.color_guide ? images_.left_color() : images_.left_gray();
  aggregator_.Run(*costs, guide, aggregation, PathPrior(), 0, pool, &winners_);
  RefineSubpixel(winners_, Subpixel::kParabola, &disparity_, pool);
  confident_.Select(winners_.uncertainty, disparity_, winners_.right_winner, shape.min_disparity,
                    options.prior.keep_quantile, pool);
}

RadiometricFit CoarsePass::FitRadiometry(CostKind kind) {
  if (kind != CostKind::kMixed) return RadiometricFit();
  return radiometry_.Fit(images_.left_gray(), images_.right_gray(), disparity_, confident());
}

}  // namespace stereo_sgmp
