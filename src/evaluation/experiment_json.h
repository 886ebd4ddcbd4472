#ifndef STEREO_SGMP_EVALUATION_EXPERIMENT_JSON_H_
#define STEREO_SGMP_EVALUATION_EXPERIMENT_JSON_H_

#include <string>

#include "evaluation/experiment.h"
#include "stereo_sgmp/options.h"

namespace stereo_sgmp {

// All of an experiment as JSON: format (1), thresholds, report_threshold (that of the curves and
// gains), min_error_share, options (those of the matcher but for the variant and the disparity
// range, which differ within the experiment), machine, scenes, variants, and results: an object
// per scene and variant, named as the fields of SceneScore. Gain and overhead are shares as in
// SceneGain; what is not known is null.
std::string ExperimentJson(const Experiment& experiment, const std::string& preset,
                           const Options& options);

}  // namespace stereo_sgmp

#endif  // STEREO_SGMP_EVALUATION_EXPERIMENT_JSON_H_
