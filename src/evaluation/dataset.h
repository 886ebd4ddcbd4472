// Scenes with ground truth on disk, in the layouts of the public data sets.
#ifndef STEREO_SGMP_EVALUATION_DATASET_H_
#define STEREO_SGMP_EVALUATION_DATASET_H_

#include <string>
#include <vector>

#include "evaluation/datasets/scene_layout.h"
#include "evaluation/stereo_scene.h"

namespace stereo_sgmp {

// The scenes among `paths` and directly in them, in the order given and by name within one
// folder; see SceneLayout of how they are named. Throws std::invalid_argument for a path that
// neither is nor contains a scene.
std::vector<std::string> FindScenes(const std::vector<std::string>& paths);

// Throws std::invalid_argument for files that are missing, malformed or do not fit together.
StereoScene LoadScene(const std::string& path, const DatasetOptions& options = {});

// Writes the scene into `folder`, which is created if needed, in the layout of Middlebury v3.
void SaveScene(const std::string& folder, const StereoScene& scene);

}  // namespace stereo_sgmp

#endif  // STEREO_SGMP_EVALUATION_DATASET_H_
