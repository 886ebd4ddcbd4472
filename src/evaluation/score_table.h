// Scores for people and for programs.
#ifndef STEREO_SGMP_EVALUATION_SCORE_TABLE_H_
#define STEREO_SGMP_EVALUATION_SCORE_TABLE_H_

#include <vector>

#include "evaluation/experiment.h"
#include "evaluation/table.h"

namespace stereo_sgmp {

// Of one method: a row per scene, and their mean as the last one.
Table ScoreTable(const std::vector<SceneScore>& scores, const ScoreOptions& options);

// Of several methods: a row per score, with its gain and overhead, percent.
Table ExperimentTable(const Experiment& experiment);

// The raw errors at the curve's threshold: a row per scene and a column per method, and the mean
// over the scenes that all methods have as the last row.
Table ErrorTable(const Experiment& experiment);

// A column per method: the means of all scores over the scenes that all methods have, and the
// gains over the baseline.
Table MethodTable(const Experiment& experiment);

}  // namespace stereo_sgmp

#endif  // STEREO_SGMP_EVALUATION_SCORE_TABLE_H_
