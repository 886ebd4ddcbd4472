#include "evaluation/report_folder.h"

#include <stdexcept>
#include <system_error>

#include "evaluation/error_map.h"
#include "evaluation/experiment_json.h"
#include "evaluation/metrics.h"
#include "evaluation/score_table.h"
#include "io/color_map.h"
#include "io/file_io.h"
#include "io/image.h"

namespace stereo_sgmp {

namespace fs = std::filesystem;

namespace {

// In one range of colours for all maps of a scene, so that they can be compared.
cv::Mat ColorsOf(const cv::Mat& disparity, const StereoScene& scene) {
  double min = 0.0;
  double max = 0.0;
  cv::minMaxLoc(scene.disparity, &min, &max, nullptr, nullptr,
                EvaluatedPixels(scene.disparity, cv::Mat()));
  return ColorDisparity(disparity, min, max);
}

}  // namespace

ReportFolder::ReportFolder(const std::string& folder, const ScoreOptions& options)
    : folder_(folder), options_(options) {
  std::error_code error;
  fs::create_directories(folder_ / "maps", error);
  if (error) {
    throw std::invalid_argument(folder + ": the folder can't be made (" + error.message() + ").");
  }
}

std::string ReportFolder::MapPath(const std::string& scene, const std::string& name) const {
  return (folder_ / "maps" / (scene + "_" + name + ".png")).string();
}

void ReportFolder::AddScene(const StereoScene& scene) const {
  // 16 bit are far larger, and no better to look at.
  SaveImage(MapPath(scene.name, "left"), To8Bit(scene.left));
  SaveImage(MapPath(scene.name, "truth"), ColorsOf(scene.disparity, scene));
}

void ReportFolder::AddResult(const StereoScene& scene, const std::string& method,
                             const MethodResult& result) const {
  const cv::Mat evaluated = EvaluatedPixels(scene.disparity, scene.mask);
  SaveImage(MapPath(scene.name, method + "_disparity"), ColorsOf(result.raw, scene));
  SaveImage(
      MapPath(scene.name, method + "_error"),
      ErrorMap(result.raw, scene.disparity, evaluated, options_.Bound(options_.curve_threshold)));
}

void ReportFolder::Finish(const Experiment& experiment, const std::string& preset,
                          const Options& options) const {
  WriteFile((folder_ / "results.json").string(), ExperimentJson(experiment, preset, options));
  WriteFile((folder_ / "results.csv").string(), ExperimentTable(experiment).ToCsv());
}

}  // namespace stereo_sgmp
