#include "stereo_sgmp/presets.h"

#include <stdexcept>

#include "common/excerpt.h"

namespace stereo_sgmp {
namespace {

Options Quality() {
  Options options;
  options.aggregation.scheme = PathScheme::kFourTwice;
  options.prior.coarse_factor = 3;
  options.refinement.median = false;
  options.refinement.weighted_median = true;
  options.refinement.plane_propagation = true;
  options.refinement.plane_smoothing = true;
  options.refinement.superpixel_planes = true;
  return options;
}

// Section 4 of the paper; what it leaves open is set as the reproduction measured best.
Options Paper() {
  Options options;
  options.narrow_range = false;
  options.cost.kind = CostKind::kNcc;
  options.cost.ncc_epsilon = 1.0;
  options.cost.vertical_tolerance = true;
  options.aggregation.p1 = 100;
  options.aggregation.alpha = 8.0;
  options.aggregation.beta = 10.0;
  options.aggregation.color_guide = false;
  options.prior.variant = Variant::kEpi;
  options.prior.jump_slack = 15;
  options.prior.attraction = 0.0;
  options.prior.min_slope = 0.0;
  options.prior.min_plane_area = 60;
  options.prior.spread = false;
  options.refinement.subpixel = Subpixel::kEquiangular;
  options.filter.confidence = ConfidenceMeasure::kUncertainty;
  return options;
}

}  // namespace

const std::vector<std::string>& PresetNames() {
  static const std::vector<std::string> kNames{"default", "quality", "paper"};
  return kNames;
}

Options PresetOptions(const std::string& name) {
  if (name == "default") return Options();
  if (name == "quality") return Quality();
  if (name == "paper") return Paper();
  throw std::invalid_argument("there is no preset '" + Excerpt(name) +
                              "'; expected default, quality or paper");
}

}  // namespace stereo_sgmp
