#ifndef STEREO_SGMP_EVALUATION_SCORE_H_
#define STEREO_SGMP_EVALUATION_SCORE_H_

#include <array>
#include <string>
#include <vector>

#include "evaluation/dataset.h"
#include "evaluation/table.h"
#include "stereo_sgmp/match_result.h"

namespace stereo_sgmp {

struct ScoreOptions {
  std::vector<double> thresholds = {0.5, 1.0, 2.0};  // of bad pixels at 100 % completeness
  double curve_threshold = 2.0;                      // of the error-completeness curve; the paper's
};

inline constexpr std::array<double, 4> kScoredCompleteness = {0.6, 0.7, 0.8, 0.9};

// How good a result is, on the non-occluded pixels with ground truth. Percent but for seconds.
struct SceneScore {
  std::string name;
  std::vector<double> bad_raw;    // at each threshold, MatchResult::raw
  std::vector<double> bad_dense;  // at each threshold, MatchResult::dense
  // Of the raw disparities: errors where the least certain pixels by U_p are left out, and areas
  // under the curve by U_p and by the published confidence.
  std::array<double, kScoredCompleteness.size()> error_at{};
  double area_uncertainty = 0.0;
  double area_confidence = 0.0;
  double seconds = 0.0;  // the whole frame
};

SceneScore ScoreResult(const StereoScene& scene, const MatchResult& result,
                       const ScoreOptions& options);

// A row per scene, and their mean as the last one.
Table ScoreTable(const std::vector<SceneScore>& scores, const ScoreOptions& options);

}  // namespace stereo_sgmp

#endif  // STEREO_SGMP_EVALUATION_SCORE_H_
