#include "evaluation/experiment.h"

#include <gtest/gtest.h>

namespace stereo_sgmp {
namespace {

Experiment OneScoreMissing() {
  Experiment experiment;
  experiment.scenes = {{"a"}, {"b"}};
  experiment.methods = {"sgm", "mw"};
  experiment.scores.resize(3);
  experiment.scores[0].scene = experiment.scores[1].scene = "a";
  experiment.scores[2].scene = "b";
  experiment.scores[0].method = experiment.scores[2].method = "sgm";
  experiment.scores[1].method = "mw";
  return experiment;
}

TEST(Experiment, FindsScores) {
  const Experiment experiment = OneScoreMissing();
  EXPECT_EQ(experiment.Find("a", "mw"), &experiment.scores[1]);
  EXPECT_EQ(experiment.Find("b", "mw"), nullptr);
}

TEST(Experiment, KnowsTheScenesThatAllMethodsHave) {
  EXPECT_EQ(OneScoreMissing().CommonScenes(), std::vector<std::string>{"a"});
}

TEST(Experiment, TellsScenesOfOneNameApart) {
  Experiment experiment = OneScoreMissing();
  EXPECT_EQ(experiment.UniqueSceneName("c"), "c");
  EXPECT_EQ(experiment.UniqueSceneName("a"), "a_2");
  experiment.scenes.push_back({"a_2"});
  EXPECT_EQ(experiment.UniqueSceneName("a"), "a_3");
}

}  // namespace
}  // namespace stereo_sgmp
