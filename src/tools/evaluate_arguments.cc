#include "tools/evaluate_arguments.h"

#include "evaluation/methods/method_list.h"

namespace stereo_sgmp {

void EvaluateArguments::AddTo(CLI::App* app) {
  AddInputs(app);
  AddOutputs(app);
}

void EvaluateArguments::AddInputs(CLI::App* app) {
  app->add_option("folders", folders, "Scenes, or folders of scenes")->required();
  matcher.AddTo(app);
  variant_flag_ = app->get_option("--variant");
  app->add_option("--variants", variants,
                  "Several in place of --variant, separated by commas: its values, and sgbm, "
                  "sgbm_3way, hh (modes of OpenCV's StereoSGBM). gs, gp, gni and gnv take the "
                  "ground truth as their prior")
      ->delimiter(',')
      ->allow_extra_args(false)  // folders may follow
      ->check(CLI::IsMember(MethodNames()))
      ->excludes(app->get_option("--variant"));
  app->add_option("--disparity-dir", disparity_dirs,
                  "Score the disparity maps in this folder: SCENE.pfm, SCENE.png or "
                  "SCENE/disp0*.pfm; repeatable. Without --variant and --variants nothing else is")
      ->allow_extra_args(false);
  app->add_option_function<int>(
         "--num-disparities", [this](int value) { num_disparities = value; },
         "Number of disparities searched. Without it: ndisp of calib.txt, or what covers the "
         "ground truth")
      ->check(CLI::Range(1, 2048));
  app->add_option("--truth-scale", truth_scale,
                  "Disparity = value / scale of ground truth in pictures; 0: that of the data set")
      ->check(CLI::Range(0.0, 65536.0));
}

void EvaluateArguments::AddOutputs(CLI::App* app) {
  app->add_option("--threshold", thresholds,
                  "Error above which a pixel is bad, pixels; repeatable; 0.5, 1 and 2 without. "
                  "The curve and the gains are those of the first one given, and of 2 without")
      ->allow_extra_args(false)  // one value each: folders may follow
      ->check(CLI::Range(0.001, 1000.0));
  app->add_option("--error-percent", error_percent,
                  "Only errors above so many percent of the true disparity are bad; 5 for KITTI "
                  "2015")
      ->check(CLI::Range(0.0, 100.0));
  app->add_option("--csv", csv, "Write the table as CSV too; - is stdout in place of the table");
  app->add_option("--report", report,
                  "Write a folder with all numbers and pictures, from which scripts/report makes "
                  "figures");
}

}  // namespace stereo_sgmp
