// Scores the matcher on scenes with ground truth.
#include <algorithm>
#include <iostream>
#include <string>
#include <vector>

#include "evaluation/dataset.h"
#include "evaluation/score.h"
#include "io/file_io.h"
#include "stereo_sgmp/matcher.h"
#include "tools/matcher_flags.h"
#include "tools/progress_line.h"
#include "tools/tool_main.h"

namespace stereo_sgmp {
namespace {

constexpr char kDescription[] =
    "Matches stereo pairs and compares them with their ground truth, on the pixels that both\n"
    "cameras see. A scene is a folder with im0.png, im1.png, disp0GT.pfm and, if there are any,\n"
    "mask0nocc.png and calib.txt.\n"
    "Examples:\n"
    "  evaluate scenes/                        all scenes in a folder\n"
    "  evaluate scenes/ --variant sgm          the same without orientation prior\n"
    "  evaluate a b --threshold 1 --csv -      two scenes, errors above 1 pixel, as CSV\n"
    "Columns, percent: raw_bad_T and dense_bad_T are the pixels wrong by more than T, of the\n"
    "unfiltered and of the filled map; bad_T_at_C those of the C % most certain raw pixels; the\n"
    "areas are those under the error-completeness curve, by U of the paper and by confidence.";

struct Arguments {
  MatcherFlags matcher;
  std::vector<std::string> folders;
  std::vector<double> thresholds;
  std::string csv;
};

void AddFlags(CLI::App* app, Arguments* a) {
  app->add_option("folders", a->folders, "Scenes, or folders of scenes")->required();
  a->matcher.AddTo(app);
  app->add_option("--threshold", a->thresholds,
                  "Error above which a pixel is bad, pixels; repeatable; 0.5, 1 and 2 without. "
                  "The curve is that of the first one given, and of 2 without")
      ->allow_extra_args(false)  // one value each: folders may follow
      ->check(CLI::Range(0.001, 1000.0));
  app->add_option("--csv", a->csv, "Write the table as CSV too; - is stdout in place of the table");
}

SceneScore Evaluate(const StereoScene& scene, Options options, const ScoreOptions& score_options) {
  if (scene.calibration && scene.calibration->num_disparities > 0) {
    options.num_disparities = scene.calibration->num_disparities;
  } else {
    options.num_disparities = std::min(options.num_disparities, scene.left.cols);
  }
  Matcher matcher(options);
  MatchResult result;
  matcher.Match(scene.left, scene.right, &result);
  return ScoreResult(scene, result, score_options);
}

void Run(const Arguments& a) {
  const bool csv_to_stdout = a.csv == "-";
  if (!a.csv.empty() && !csv_to_stdout) CheckWritable(a.csv);
  const Options options = a.matcher.ToOptions();
  ScoreOptions score_options;
  if (!a.thresholds.empty()) {
    score_options.thresholds = a.thresholds;
    score_options.curve_threshold = a.thresholds.front();
  }
  const std::vector<std::string> folders = FindScenes(a.folders);
  ProgressLine progress(folders.size());
  std::vector<SceneScore> scores;
  for (const std::string& folder : folders) {
    progress.Next(folder);
    scores.push_back(Evaluate(LoadScene(folder), options, score_options));
  }
  progress.Finish();
  const Table table = ScoreTable(scores, score_options);
  std::cout << (csv_to_stdout ? table.ToCsv() : table.ToText());
  if (!a.csv.empty() && !csv_to_stdout) WriteFile(a.csv, table.ToCsv());
}

}  // namespace
}  // namespace stereo_sgmp

int main(int argc, char** argv) {
  stereo_sgmp::Arguments arguments;
  CLI::App app(stereo_sgmp::kDescription, "evaluate");
  stereo_sgmp::AddFlags(&app, &arguments);
  return stereo_sgmp::RunTool(argc, argv, &app, [&] { stereo_sgmp::Run(arguments); });
}
