#include "evaluation/gains.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numeric>
#include <vector>

namespace stereo_sgmp {
namespace {

constexpr double kNan = std::numeric_limits<double>::quiet_NaN();

double Ratio(double value, double base) { return base > 0.0 ? value / base : kNan; }

double Mean(const std::vector<double>& values) {
  if (values.empty()) return kNan;
  return std::accumulate(values.begin(), values.end(), 0.0) / static_cast<double>(values.size());
}

}  // namespace

SceneGain GainOf(const Experiment& experiment, const SceneScore& score) {
  const SceneScore* base = experiment.Find(score.scene, kBaseline);
  if (base == nullptr) return {kNan, kNan};
  return {1.0 - Ratio(score.bad_at_curve_threshold, base->bad_at_curve_threshold),
          Ratio(score.seconds, base->seconds) - 1.0};
}

MethodGain GainOverScenes(const Experiment& experiment, const std::string& method) {
  std::vector<double> gains;
  std::vector<double> overheads;
  double errors = 0.0;
  double base_errors = 0.0;
  for (const SceneScore& score : experiment.scores) {
    if (score.method != method) continue;
    const SceneGain gain = GainOf(experiment, score);
    if (!std::isnan(gain.overhead)) overheads.push_back(gain.overhead);
    if (std::isnan(gain.errors)) continue;
    gains.push_back(gain.errors);
    errors += score.bad_at_curve_threshold;
    base_errors += experiment.Find(score.scene, kBaseline)->bad_at_curve_threshold;
  }
  MethodGain total;
  total.mean_of_gains = Mean(gains);
  total.gain_of_means = 1.0 - Ratio(errors, base_errors);
  total.smallest = gains.empty() ? kNan : *std::min_element(gains.begin(), gains.end());
  total.mean_overhead = Mean(overheads);
  return total;
}

}  // namespace stereo_sgmp
