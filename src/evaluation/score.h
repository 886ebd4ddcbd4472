#ifndef STEREO_SGMP_EVALUATION_SCORE_H_
#define STEREO_SGMP_EVALUATION_SCORE_H_

#include <array>
#include <string>
#include <vector>

#include "evaluation/method_result.h"
#include "evaluation/metrics.h"
#include "evaluation/stereo_scene.h"

namespace stereo_sgmp {

struct ScoreOptions {
  std::vector<double> thresholds = {0.5, 1.0, 2.0};  // of bad pixels at 100 % completeness
  double curve_threshold = 2.0;  // of the error-completeness curve and the gains; the paper's
  double min_error_share = 0.0;  // ErrorBound::share of all thresholds

  ErrorBound Bound(double threshold) const { return {threshold, min_error_share}; }
};

inline constexpr std::array<double, 4> kScoredCompleteness = {0.6, 0.7, 0.8, 0.9};

// Error against completeness at 1, 2 ... 100 % completeness, of the raw disparities; percent.
struct SampledCurve {
  static constexpr int kSamples = 100;

  std::vector<double> completeness;      // 0.01 ... 1
  std::vector<double> error_u;           // in the order of U_p; NaN where the method has none
  std::vector<double> error_confidence;  // in the order of the confidence
};

// How good the result of a method is, on the non-occluded pixels with ground truth. Percent of
// these where nothing else is said.
struct SceneScore {
  std::string scene;
  std::string method;
  std::vector<double> bad_raw;          // at each threshold, MethodResult::raw
  std::vector<double> bad_dense;        // at each threshold, MethodResult::dense
  std::vector<double> bad_published;    // at each threshold, valid but wrong
  double invalid = 0.0;                 // not valid
  double average_error = 0.0;           // of the raw disparities that there are, pixels
  double bad_at_curve_threshold = 0.0;  // raw
  // Of the raw disparities: errors where the least certain pixels by U_p are left out, and areas
  // under the curve by U_p, by the confidence, and by a perfect one that sorts all errors last.
  // NaN where the method has no U_p.
  std::array<double, kScoredCompleteness.size()> error_at{};
  double area_uncertainty = 0.0;
  double area_confidence = 0.0;
  double area_oracle = 0.0;
  SampledCurve curve;
  double seconds = 0.0;  // the whole frame; NaN where it is not known
};

SceneScore ScoreResult(const StereoScene& scene, const std::string& method,
                       const MethodResult& result, const ScoreOptions& options);

}  // namespace stereo_sgmp

#endif  // STEREO_SGMP_EVALUATION_SCORE_H_
