#include "evaluation/gains.h"

#include <cmath>
#include <string>

#include <gtest/gtest.h>

namespace stereo_sgmp {
namespace {

SceneScore Score(const std::string& scene, const std::string& method, double bad, double seconds) {
  SceneScore score;
  score.scene = scene;
  score.method = method;
  score.bad_at_curve_threshold = bad;
  score.seconds = seconds;
  return score;
}

// Of the paper's results: Adirondack and Piano.
Experiment Paper() {
  Experiment experiment;
  experiment.scenes = {{"Adirondack"}, {"Piano"}};
  experiment.methods = {"sgm", "epi"};
  experiment.scores = {Score("Adirondack", "sgm", 20.3, 2), Score("Adirondack", "epi", 12.0, 3),
                       Score("Piano", "sgm", 21.1, 4), Score("Piano", "epi", 20.1, 5)};
  return experiment;
}

TEST(GainOf, ComparesWithTheBaselineOfTheScene) {
  const Experiment experiment = Paper();
  EXPECT_NEAR(GainOf(experiment, experiment.scores[1]).errors, 0.409, 5e-4);
  EXPECT_NEAR(GainOf(experiment, experiment.scores[3]).errors, 0.0474, 5e-4);
  EXPECT_DOUBLE_EQ(GainOf(experiment, experiment.scores[1]).overhead, 0.5);
  EXPECT_DOUBLE_EQ(GainOf(experiment, experiment.scores[0]).errors, 0);
}

TEST(GainOf, IsNotKnownWithoutErrorsToGain) {
  Experiment experiment = Paper();
  experiment.scores[0].bad_at_curve_threshold = 0;
  EXPECT_TRUE(std::isnan(GainOf(experiment, experiment.scores[1]).errors));
  experiment.scores.erase(experiment.scores.begin());
  EXPECT_TRUE(std::isnan(GainOf(experiment, experiment.scores[0]).errors));
  EXPECT_TRUE(std::isnan(GainOf(experiment, experiment.scores[0]).overhead));
}

TEST(GainOverScenes, AveragesGainsAndErrors) {
  const MethodGain gain = GainOverScenes(Paper(), "epi");
  const double first = (20.3 - 12.0) / 20.3;
  const double second = (21.1 - 20.1) / 21.1;
  EXPECT_DOUBLE_EQ(gain.mean_of_gains, (first + second) / 2);
  EXPECT_DOUBLE_EQ(gain.gain_of_means, 1 - (12.0 + 20.1) / (20.3 + 21.1));
  EXPECT_NEAR(gain.smallest, second, 1e-12);
  EXPECT_DOUBLE_EQ(gain.mean_overhead, (0.5 + 0.25) / 2);
}

TEST(GainOverScenes, LeavesOutScenesWithoutGain) {
  Experiment experiment = Paper();
  experiment.scores[2].bad_at_curve_threshold = 0;
  experiment.scores[3].bad_at_curve_threshold = 7;
  EXPECT_NEAR(GainOverScenes(experiment, "epi").gain_of_means, 0.409, 5e-4);
  EXPECT_TRUE(std::isnan(GainOverScenes(experiment, "gs").mean_of_gains));
  EXPECT_TRUE(std::isnan(GainOverScenes(experiment, "gs").gain_of_means));
}

}  // namespace
}  // namespace stereo_sgmp
