#ifndef STEREO_SGMP_EVALUATION_DATASETS_SCENE_LAYOUT_H_
#define STEREO_SGMP_EVALUATION_DATASETS_SCENE_LAYOUT_H_

#include <filesystem>
#include <string>
#include <vector>

#include "evaluation/stereo_scene.h"

namespace stereo_sgmp {

struct DatasetOptions {
  // Ground truth in pictures: disparity = value / truth_scale. 0 takes what the data set uses.
  double truth_scale = 0.0;
};

// How the files of one data set are arranged. A scene is named by the path of its folder or,
// where one folder holds many scenes, of its left image.
struct SceneLayout {
  const char* files;  // what a user has to provide, for messages

  // The scenes that `path` is or holds itself, not in its subfolders; none where it has another
  // layout. Looks at names only.
  std::vector<std::string> (*find)(const std::filesystem::path& path);

  // Loads one that `find` returned. Throws std::invalid_argument for files that are missing,
  // malformed or do not fit together.
  StereoScene (*load)(const std::filesystem::path& path, const DatasetOptions& options);
};

}  // namespace stereo_sgmp

#endif  // STEREO_SGMP_EVALUATION_DATASETS_SCENE_LAYOUT_H_
