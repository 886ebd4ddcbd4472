// Scores the matcher, and others beside it, on scenes with ground truth.
#include <algorithm>
#include <iostream>
#include <memory>
#include <optional>
#include <stdexcept>
#include <string>
#include <vector>

#include "evaluation/dataset.h"
#include "evaluation/disparity_range.h"
#include "evaluation/experiment.h"
#include "evaluation/methods/file_method.h"
#include "evaluation/methods/matcher_method.h"
#include "evaluation/methods/method_list.h"
#include "evaluation/report_folder.h"
#include "evaluation/score_table.h"
#include "io/file_io.h"
#include "tools/evaluate_arguments.h"
#include "tools/progress_line.h"
#include "tools/tool_main.h"

namespace stereo_sgmp {
namespace {

constexpr char kDescription[] =
    "Matches stereo pairs and compares them with their ground truth, on the pixels that both\n"
    "cameras see. Scenes are folders of the Middlebury evaluation v3 or of ETH3D (im0.png,\n"
    "im1.png, disp0GT.pfm and, if there are any, mask0nocc.png and calib.txt), of the Middlebury\n"
    "data sets of 2001 to 2006 (im2, im6, disp2 or view1, view5, disp1), or the frames of KITTI's\n"
    "folder training.\n"
    "Examples:\n"
    "  evaluate scenes/                        all scenes in a folder\n"
    "  evaluate scenes/ --variant sgm          the same without orientation prior\n"
    "  evaluate a b --threshold 1 --csv -      two scenes, errors above 1 pixel, as CSV\n"
    "  evaluate scenes/ --variants sgm,epi,gs,hh --report out     what scripts/report draws\n"
    "  evaluate scenes/ --disparity-dir maps   maps/SCENE.pfm that others made\n"
    "  evaluate kitti/training --threshold 3 --error-percent 5    as KITTI 2015 counts\n"
    "Columns, percent: raw_bad_T and dense_bad_T are the pixels wrong by more than T, of the\n"
    "unfiltered and of the filled map; published_bad_T those wrong and not marked as invalid, and\n"
    "published_total_T these and the invalid ones; bad_T_at_C those of the C % most certain raw\n"
    "pixels; the areas are those under the error-completeness curve, by U of the paper and by\n"
    "confidence; gains are those in raw errors over the variant sgm.";

ScoreOptions ScoreOptionsOf(const EvaluateArguments& a) {
  ScoreOptions options;
  if (!a.thresholds.empty()) {
    options.thresholds = a.thresholds;
    options.curve_threshold = a.thresholds.front();
  }
  options.min_error_share = a.error_percent / 100.0;
  return options;
}

using Methods = std::vector<std::unique_ptr<StereoMethod>>;

Methods MethodsOf(const EvaluateArguments& a, const Options& options) {
  Methods methods;
  for (const std::string& name : a.variants) methods.push_back(MakeMethod(name, options));
  const bool only_files = !a.disparity_dirs.empty() && !a.variant_given();
  if (methods.empty() && !only_files) {
    methods.push_back(std::make_unique<MatcherMethod>(options.prior.variant, options));
  }
  for (const std::string& folder : a.disparity_dirs) {
    methods.push_back(std::make_unique<FileMethod>(folder));
  }
  return methods;
}

std::vector<std::string> UniqueNames(const Methods& methods) {
  std::vector<std::string> names;
  for (const auto& method : methods) {
    if (std::find(names.begin(), names.end(), method->name()) != names.end()) {
      throw std::invalid_argument("Two methods are called " + method->name() +
                                  "; name each variant once and each folder differently.");
    }
    names.push_back(method->name());
  }
  return names;
}

// Adds the scores of the methods that can run on the scene, and a sentence to `notes` for each of
// the others. `report` may be null.
void EvaluateScene(const StereoScene& scene, const Methods& methods, const ReportFolder* report,
                   Experiment* experiment, std::string* notes) {
  const int num_disparities = experiment->scenes.back().disparities;
  if (report != nullptr) report->AddScene(scene);
  for (const auto& method : methods) {
    const std::string missing = method->Missing(scene);
    if (!missing.empty()) {
      *notes += scene.name + ": " + method->name() + " is skipped, as it needs " + missing + ".\n";
      continue;
    }
    const MethodResult result = method->Run(scene, num_disparities);
    experiment->scores.push_back(ScoreResult(scene, method->name(), result, experiment->options));
    if (report != nullptr) report->AddResult(scene, method->name(), result);
  }
}

void Print(const Experiment& experiment, const EvaluateArguments& a) {
  const bool one = experiment.methods.size() == 1 && a.disparity_dirs.empty();
  const Table all =
      one ? ScoreTable(experiment.scores, experiment.options) : ExperimentTable(experiment);
  if (a.csv == "-") {
    std::cout << all.ToCsv();
    return;
  }
  if (one) {
    std::cout << all.ToText();
  } else {
    std::cout << ErrorTable(experiment).ToText() << '\n' << MethodTable(experiment).ToText();
  }
  if (!a.csv.empty()) WriteFile(a.csv, all.ToCsv());
}

void Run(const EvaluateArguments& a) {
  if (!a.csv.empty() && a.csv != "-") CheckWritable(a.csv);
  const Options options = a.matcher.ToOptions();
  const Methods methods = MethodsOf(a, options);
  const std::vector<std::string> paths = FindScenes(a.folders);
  Experiment experiment;
  experiment.options = ScoreOptionsOf(a);
  experiment.methods = UniqueNames(methods);
  std::optional<ReportFolder> report;
  if (!a.report.empty()) report.emplace(a.report, experiment.options);
  std::string notes;
  ProgressLine progress(paths.size());
  for (const std::string& path : paths) {
    progress.Next(path);
    StereoScene scene = LoadScene(path, {a.truth_scale});
    scene.name = experiment.UniqueSceneName(scene.name);
    const int disparities = a.num_disparities.value_or(DisparitiesToSearch(scene, options));
    experiment.scenes.push_back({scene.name, scene.left.cols, scene.left.rows, disparities});
    EvaluateScene(scene, methods, report ? &*report : nullptr, &experiment, &notes);
  }
  progress.Finish();
  std::cerr << notes;
  if (experiment.scores.empty()) {
    throw std::invalid_argument("None of the methods can run on any of the scenes.");
  }
  Print(experiment, a);
  if (report) report->Finish(experiment, a.matcher.preset(), options);
}

}  // namespace
}  // namespace stereo_sgmp

int main(int argc, char** argv) {
  stereo_sgmp::EvaluateArguments arguments;
  CLI::App app(stereo_sgmp::kDescription, "evaluate");
  arguments.AddTo(&app);
  return stereo_sgmp::RunTool(argc, argv, &app, [&] { stereo_sgmp::Run(arguments); });
}
