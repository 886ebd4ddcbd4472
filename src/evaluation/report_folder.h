#ifndef STEREO_SGMP_EVALUATION_REPORT_FOLDER_H_
#define STEREO_SGMP_EVALUATION_REPORT_FOLDER_H_

#include <filesystem>
#include <string>

#include "evaluation/experiment.h"
#include "evaluation/method_result.h"
#include "evaluation/stereo_scene.h"
#include "stereo_sgmp/options.h"

namespace stereo_sgmp {

// A folder that holds all of an experiment, for scripts/report:
//   results.json               see ExperimentJson
//   results.csv                see ExperimentTable
//   maps/SCENE_left.png        the left image
//   maps/SCENE_truth.png       the ground truth in the colours of ColorDisparity
//   maps/SCENE_METHOD_disparity.png  raw disparities, in the range of the scene's ground truth
//   maps/SCENE_METHOD_error.png      their ErrorMap at the curve's threshold
class ReportFolder {
 public:
  // Creates the folder where needed. Throws std::invalid_argument when that can't be done.
  ReportFolder(const std::string& folder, const ScoreOptions& options);

  // Throw std::runtime_error when a file can't be written.
  void AddScene(const StereoScene& scene) const;
  void AddResult(const StereoScene& scene, const std::string& method,
                 const MethodResult& result) const;
  void Finish(const Experiment& experiment, const std::string& preset,
              const Options& options) const;

 private:
  std::string MapPath(const std::string& scene, const std::string& name) const;

  std::filesystem::path folder_;
  ScoreOptions options_;
};

}  // namespace stereo_sgmp

#endif  // STEREO_SGMP_EVALUATION_REPORT_FOLDER_H_
