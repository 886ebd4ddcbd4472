#include "evaluation/dataset.h"

#include <algorithm>
#include <array>
#include <filesystem>
#include <stdexcept>

#include "evaluation/datasets/kitti.h"
#include "evaluation/datasets/middlebury_pictures.h"
#include "evaluation/datasets/middlebury_v3.h"

namespace stereo_sgmp {

namespace fs = std::filesystem;

namespace {

std::array<const SceneLayout*, 4> Layouts() {
  return {&kMiddleburyV3Layout, &kMiddlebury2003Layout, &kMiddlebury2006Layout, &kKittiLayout};
}

std::vector<std::string> ScenesAt(const fs::path& path) {
  for (const SceneLayout* layout : Layouts()) {
    std::vector<std::string> scenes = layout->find(path);
    if (!scenes.empty()) return scenes;
  }
  return {};
}

[[noreturn]] void FailWithoutScene(const fs::path& path) {
  std::string files;
  for (const SceneLayout* layout : Layouts()) {
    files += (files.empty() ? "" : "; or ") + std::string(layout->files);
  }
  throw std::invalid_argument(
      path.string() + ": neither a scene nor a folder of scenes; expected are " + files + ".");
}

std::vector<std::string> ScenesAtOrIn(const fs::path& path) {
  if (!fs::exists(path)) throw std::invalid_argument(path.string() + ": there is no such folder.");
  std::vector<std::string> scenes = ScenesAt(path);
  if (!scenes.empty()) return scenes;
  if (fs::is_directory(path)) {
    for (const fs::directory_entry& entry : fs::directory_iterator(path)) {
      if (!entry.is_directory()) continue;
      const std::vector<std::string> found = ScenesAt(entry.path());
      scenes.insert(scenes.end(), found.begin(), found.end());
    }
  }
  if (scenes.empty()) FailWithoutScene(path);
  std::sort(scenes.begin(), scenes.end());
  return scenes;
}

// The last part of the path, without the extension of a file.
std::string NameOf(const fs::path& path) {
  // "scene/" has an empty file name; its parent is "scene".
  const fs::path name = (path.has_filename() ? path : path.parent_path()).filename();
  return (fs::is_directory(path) ? name : name.stem()).string();
}

}  // namespace

std::vector<std::string> FindScenes(const std::vector<std::string>& paths) {
  std::vector<std::string> scenes;
  for (const std::string& path : paths) {
    const std::vector<std::string> found = ScenesAtOrIn(path);
    scenes.insert(scenes.end(), found.begin(), found.end());
  }
  return scenes;
}

StereoScene LoadScene(const std::string& path, const DatasetOptions& options) {
  for (const SceneLayout* layout : Layouts()) {
    const std::vector<std::string> scenes = layout->find(path);
    if (std::find(scenes.begin(), scenes.end(), path) == scenes.end()) continue;
    StereoScene scene = layout->load(path, options);
    scene.name = NameOf(path);
    return scene;
  }
  FailWithoutScene(path);
}

void SaveScene(const std::string& folder, const StereoScene& scene) {
  SaveMiddleburyV3(folder, scene);
}

}  // namespace stereo_sgmp
