#include "evaluation/experiment.h"

#include <algorithm>

namespace stereo_sgmp {

const SceneScore* Experiment::Find(const std::string& scene, const std::string& method) const {
  const auto found = std::find_if(scores.begin(), scores.end(), [&](const SceneScore& score) {
    return score.scene == scene && score.method == method;
  });
  return found == scores.end() ? nullptr : &*found;
}

std::string Experiment::UniqueSceneName(const std::string& name) const {
  std::string unique = name;
  const auto taken = [&](const SceneInfo& scene) { return scene.name == unique; };
  for (int i = 2; std::any_of(scenes.begin(), scenes.end(), taken); ++i) {
    unique = name + "_" + std::to_string(i);
  }
  return unique;
}

std::vector<std::string> Experiment::CommonScenes() const {
  std::vector<std::string> common;
  for (const SceneInfo& scene : scenes) {
    const bool everywhere =
        std::all_of(methods.begin(), methods.end(),
                    [&](const std::string& method) { return Find(scene.name, method) != nullptr; });
    if (everywhere) common.push_back(scene.name);
  }
  return common;
}

}  // namespace stereo_sgmp
