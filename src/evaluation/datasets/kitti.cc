#include "evaluation/datasets/kitti.h"

#include <algorithm>

#include "evaluation/datasets/scene_files.h"
#include "io/disparity_file.h"

namespace stereo_sgmp {

namespace fs = std::filesystem;

namespace {

// The folders of one training set.
struct Folders {
  fs::path left;
  fs::path right;
  fs::path truth;

  explicit Folders(const fs::path& training)
      : left(FirstFile(training, {"image_2", "image_0"})),
        right(training / (left.filename() == "image_2" ? "image_3" : "image_1")),
        truth(FirstFile(training, {"disp_noc_0", "disp_noc"})) {}

  bool exist() const { return !left.empty() && !truth.empty(); }
};

// Frame 10 of each sequence has ground truth; 11, its successor, is there for optical flow.
bool IsFrame(const fs::path& file) {
  const std::string name = file.filename().string();
  const std::string ending = "_10.png";
  return name.size() > ending.size() &&
         name.compare(name.size() - ending.size(), ending.size(), ending) == 0;
}

std::vector<std::string> FramesIn(const Folders& folders) {
  std::vector<std::string> frames;
  for (const fs::directory_entry& entry : fs::directory_iterator(folders.truth)) {
    if (IsFrame(entry.path())) frames.push_back((folders.left / entry.path().filename()).string());
  }
  std::sort(frames.begin(), frames.end());
  return frames;
}

std::vector<std::string> Find(const fs::path& path) {
  if (fs::is_directory(path)) {
    const Folders folders(path);
    return folders.exist() ? FramesIn(folders) : std::vector<std::string>();
  }
  const bool known = IsFrame(path) && Folders(path.parent_path().parent_path()).exist();
  return known ? std::vector<std::string>{path.string()} : std::vector<std::string>();
}

StereoScene Load(const fs::path& path, const DatasetOptions& options) {
  const Folders folders(path.parent_path().parent_path());
  StereoScene scene;
  LoadImages(path, folders.right / path.filename(), &scene);
  const fs::path truth = folders.truth / path.filename();
  scene.disparity = ReadDisparity(truth.string(), options.truth_scale);
  CheckSize(truth, scene.disparity, scene);
  return scene;
}

}  // namespace

const SceneLayout kKittiLayout = {"a KITTI training folder with image_2, image_3 and disp_noc_0",
                                  Find, Load};

}  // namespace stereo_sgmp
