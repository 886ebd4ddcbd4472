// How much better than plain SGM, and at what price.
#ifndef STEREO_SGMP_EVALUATION_GAINS_H_
#define STEREO_SGMP_EVALUATION_GAINS_H_

#include <string>

#include "evaluation/experiment.h"

namespace stereo_sgmp {

inline constexpr char kBaseline[] = "sgm";

// A score beside that of the baseline on the same scene. NaN where there is none, or nothing to
// gain.
struct SceneGain {
  double errors = 0.0;    // (e_sgm - e) / e_sgm, raw errors at the curve's threshold; 1 = none left
  double overhead = 0.0;  // t / t_sgm - 1
};

SceneGain GainOf(const Experiment& experiment, const SceneScore& score);

// The gains of one method, over the scenes on which it has one.
struct MethodGain {
  double mean_of_gains = 0.0;  // as the paper averages
  double gain_of_means = 0.0;  // of the mean errors: scenes count by their errors
  double smallest = 0.0;
  double mean_overhead = 0.0;
};

// NaN where there is no such scene.
MethodGain GainOverScenes(const Experiment& experiment, const std::string& method);

}  // namespace stereo_sgmp

#endif  // STEREO_SGMP_EVALUATION_GAINS_H_
