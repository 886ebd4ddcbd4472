#include "evaluation/methods/matcher_method.h"

#include <limits>

#include "evaluation/metrics.h"
#include "geometry/normals_from_disparity.h"
#include "stereo_sgmp/matcher.h"
#include "stereo_sgmp/option_fields.h"

namespace stereo_sgmp {
namespace {

// The ground truth, infinite wherever the scores take it as not known.
cv::Mat KnownDisparity(const StereoScene& scene) {
  cv::Mat known = scene.disparity.clone();
  known.setTo(std::numeric_limits<float>::infinity(), ~EvaluatedPixels(known, cv::Mat()));
  return known;
}

bool TakesSurface(Variant variant) { return variant == Variant::kGs || variant == Variant::kGp; }
bool TakesNormals(Variant variant) { return variant == Variant::kGni || variant == Variant::kGnv; }
bool TakesCamera(Variant variant) { return TakesNormals(variant) || variant == Variant::kMw; }

}  // namespace

MatcherMethod::MatcherMethod(Variant variant, const Options& options)
    : StereoMethod(NameOf(variant)), options_(options) {
  options_.prior.variant = variant;
}

std::string MatcherMethod::Missing(const StereoScene& scene) const {
  const bool lacks_camera = TakesCamera(options_.prior.variant) && !scene.calibration;
  return lacks_camera ? "the camera (calib.txt)" : "";
}

MatchInputs MatcherMethod::InputsFor(const StereoScene& scene) const {
  MatchInputs inputs;
  if (scene.calibration) inputs.camera = scene.calibration->camera;
  if (TakesSurface(options_.prior.variant)) inputs.surface = KnownDisparity(scene);
  if (TakesNormals(options_.prior.variant)) {
    inputs.normals = scene.normals.empty()
                         ? NormalsFromDisparity(KnownDisparity(scene), *inputs.camera)
                         : scene.normals;
  }
  return inputs;
}

MethodResult MatcherMethod::Run(const StereoScene& scene, int num_disparities) {
  Options options = options_;
  options.num_disparities = num_disparities;
  Matcher matcher(options);
  MatchResult found;
  matcher.Match(scene.left, scene.right, InputsFor(scene), &found);
  MethodResult result;
  result.raw = found.raw;
  result.dense = found.dense;
  result.valid = found.reason == static_cast<int>(InvalidReason::kValid);
  result.uncertainty = found.uncertainty;
  result.confidence = found.confidence;
  result.seconds = found.statistics.frame_ms / 1000.0;
  return result;
}

}  // namespace stereo_sgmp
