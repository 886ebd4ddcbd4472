#include "evaluation/score_table.h"

#include <limits>
#include <string>

#include <gtest/gtest.h>

namespace stereo_sgmp {
namespace {

SceneScore Score(const std::string& scene, const std::string& method, double raw, double dense) {
  SceneScore score;
  score.scene = scene;
  score.method = method;
  score.bad_raw = {raw};
  score.bad_dense = {dense};
  score.bad_published = {dense / 2};
  score.invalid = 10;
  score.bad_at_curve_threshold = raw;
  score.seconds = 1;
  return score;
}

// `hh` can't run on the scene b.
Experiment TwoScenes() {
  Experiment experiment;
  experiment.options.thresholds = {1.5};
  experiment.options.curve_threshold = 1.5;
  experiment.scenes = {{"a", 8, 6, 4}, {"b", 8, 6, 4}};
  experiment.methods = {"sgm", "hh"};
  experiment.scores = {Score("a", "sgm", 8, 4), Score("a", "hh", 6, 2), Score("b", "sgm", 2, 1)};
  return experiment;
}

TEST(ScoreTable, EndsWithTheMean) {
  ScoreOptions options;
  options.thresholds = {1.5};
  EXPECT_EQ(ScoreTable({Score("a", "sgm", 1, 3), Score("b", "sgm", 2, 3)}, options).ToCsv(),
            "scene,raw_bad_1.5,dense_bad_1.5,bad_2_at_60,bad_2_at_70,bad_2_at_80,bad_2_at_90,"
            "area_uncertainty,area_confidence,seconds\n"
            "a,1.000,3.000,0.000,0.000,0.000,0.000,0.000,0.000,1.000\n"
            "b,2.000,3.000,0.000,0.000,0.000,0.000,0.000,0.000,1.000\n"
            "mean,1.500,3.000,0.000,0.000,0.000,0.000,0.000,0.000,1.000\n");
}

TEST(ExperimentTable, HasARowPerScore) {
  EXPECT_EQ(ExperimentTable(TwoScenes()).ToCsv(),
            "scene,variant,raw_bad_1.5,dense_bad_1.5,published_bad_1.5,invalid,"
            "published_total_1.5,average_error,area_uncertainty,area_confidence,area_oracle,"
            "seconds,gain_percent,overhead_percent\n"
            "a,sgm,8.000,4.000,2.000,10.000,12.000,0.000,0.000,0.000,0.000,1.000,0.000,0.000\n"
            "a,hh,6.000,2.000,1.000,10.000,11.000,0.000,0.000,0.000,0.000,1.000,25.000,0.000\n"
            "b,sgm,2.000,1.000,0.500,10.000,10.500,0.000,0.000,0.000,0.000,1.000,0.000,0.000\n");
}

TEST(ErrorTable, AveragesOnlyWhatAllMethodsHave) {
  EXPECT_EQ(ErrorTable(TwoScenes()).ToCsv(),
            "raw_bad_1.5,sgm,hh\na,8.000,6.000\nb,2.000,-\nmean,8.000,6.000\n");
  Experiment apart = TwoScenes();
  apart.scores.erase(apart.scores.begin() + 1);
  EXPECT_EQ(ErrorTable(apart).ToCsv(), "raw_bad_1.5,sgm,hh\na,8.000,-\nb,2.000,-\nmean,-,-\n");
}

TEST(MethodTable, HasAColumnPerMethod) {
  const std::string csv = MethodTable(TwoScenes()).ToCsv();
  EXPECT_EQ(csv.find("mean,sgm,hh\nraw_bad_1.5,8.000,6.000\ndense_bad_1.5,4.000,2.000\n"), 0U)
      << csv;
  EXPECT_NE(csv.find("\nmean_gain_percent,0.000,25.000\n"), std::string::npos) << csv;
}

}  // namespace
}  // namespace stereo_sgmp
