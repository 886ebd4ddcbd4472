#include "evaluation/datasets/scene_files.h"

#include <stdexcept>
#include <string>

#include "io/image.h"

namespace stereo_sgmp {

namespace fs = std::filesystem;

fs::path FirstFile(const fs::path& folder, std::initializer_list<const char*> names) {
  for (const char* name : names) {
    if (fs::exists(folder / name)) return folder / name;
  }
  return {};
}

void LoadImages(const fs::path& left, const fs::path& right, StereoScene* scene) {
  scene->left = LoadImage(left.string());
  scene->right = LoadImage(right.string());
  CheckPair(scene->left, left.string(), scene->right, right.string());
}

void CheckSize(const fs::path& file, const cv::Mat& map, const StereoScene& scene) {
  if (map.size() == scene.left.size()) return;
  throw std::invalid_argument(file.string() + ": " + std::to_string(map.cols) + " x " +
                              std::to_string(map.rows) + " pixels, but the left image has " +
                              std::to_string(scene.left.cols) + " x " +
                              std::to_string(scene.left.rows) + ".");
}

}  // namespace stereo_sgmp
