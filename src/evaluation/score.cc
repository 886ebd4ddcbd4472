#include "evaluation/score.h"

#include <algorithm>
#include <limits>
#include <optional>

#include "evaluation/completeness.h"

namespace stereo_sgmp {
namespace {

constexpr double kNan = std::numeric_limits<double>::quiet_NaN();

void ScoreMaps(const StereoScene& scene, const MethodResult& result, const cv::Mat& evaluated,
               const ScoreOptions& options, SceneScore* score) {
  for (const double threshold : options.thresholds) {
    const ErrorBound bound = options.Bound(threshold);
    const cv::Mat bad_dense = BadPixels(result.dense, scene.disparity, evaluated, bound);
    score->bad_raw.push_back(BadPercent(result.raw, scene.disparity, evaluated, bound));
    score->bad_dense.push_back(PercentOf(evaluated, bad_dense));
    score->bad_published.push_back(PercentOf(evaluated, bad_dense & result.valid));
  }
  score->invalid = PercentOf(evaluated, ~result.valid);
  score->average_error = AverageError(result.raw, scene.disparity, evaluated);
}

void ScoreCurves(const MethodResult& result, const cv::Mat& bad, const cv::Mat& evaluated,
                 SceneScore* score) {
  const CompletenessCurve by_confidence(bad, evaluated, -result.confidence);
  std::optional<CompletenessCurve> by_uncertainty;
  if (!result.uncertainty.empty()) by_uncertainty.emplace(bad, evaluated, result.uncertainty);
  const auto error_by_u = [&](double completeness) {
    return by_uncertainty ? by_uncertainty->ErrorAt(completeness) : kNan;
  };
  std::transform(kScoredCompleteness.begin(), kScoredCompleteness.end(), score->error_at.begin(),
                 error_by_u);
  for (int i = 1; i <= SampledCurve::kSamples; ++i) {
    const double completeness = static_cast<double>(i) / SampledCurve::kSamples;
    score->curve.completeness.push_back(completeness);
    score->curve.error_u.push_back(error_by_u(completeness));
    score->curve.error_confidence.push_back(by_confidence.ErrorAt(completeness));
  }
  score->area_uncertainty = by_uncertainty ? by_uncertainty->Area() : kNan;
  score->area_confidence = by_confidence.Area();
}

}  // namespace

SceneScore ScoreResult(const StereoScene& scene, const std::string& method,
                       const MethodResult& result, const ScoreOptions& options) {
  const cv::Mat evaluated = EvaluatedPixels(scene.disparity, scene.mask);
  SceneScore score;
  score.scene = scene.name;
  score.method = method;
  ScoreMaps(scene, result, evaluated, options, &score);
  const cv::Mat bad =
      BadPixels(result.raw, scene.disparity, evaluated, options.Bound(options.curve_threshold));
  score.bad_at_curve_threshold = PercentOf(evaluated, bad);
  ScoreCurves(result, bad, evaluated, &score);
  cv::Mat is_bad;
  bad.convertTo(is_bad, CV_32F);
  score.area_oracle = CompletenessCurve(bad, evaluated, is_bad).Area();
  score.seconds = result.seconds;
  return score;
}

}  // namespace stereo_sgmp
