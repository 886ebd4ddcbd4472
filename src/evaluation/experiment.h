#ifndef STEREO_SGMP_EVALUATION_EXPERIMENT_H_
#define STEREO_SGMP_EVALUATION_EXPERIMENT_H_

#include <string>
#include <vector>

#include "evaluation/score.h"

namespace stereo_sgmp {

struct SceneInfo {
  std::string name;
  int width = 0;  // pixels
  int height = 0;
  int disparities = 0;  // searched
};

// Several methods, scored on several scenes. A score may be missing where a method can't run.
struct Experiment {
  ScoreOptions options;
  std::vector<SceneInfo> scenes;     // names are unique
  std::vector<std::string> methods;  // in the order they are shown, unique
  std::vector<SceneScore> scores;

  // The score of a method on a scene; nullptr where there is none.
  const SceneScore* Find(const std::string& scene, const std::string& method) const;

  // `name`, and "NAME_2" and so on where scenes have it already.
  std::string UniqueSceneName(const std::string& name) const;

  // The scenes on which every method has a score: means over others can't be compared.
  std::vector<std::string> CommonScenes() const;
};

}  // namespace stereo_sgmp

#endif  // STEREO_SGMP_EVALUATION_EXPERIMENT_H_
