#include "evaluation/dataset.h"

#include <algorithm>
#include <filesystem>
#include <stdexcept>

#include "io/image.h"
#include "io/pfm.h"

namespace stereo_sgmp {

namespace fs = std::filesystem;

namespace {

constexpr char kLeft[] = "im0.png";
constexpr char kRight[] = "im1.png";
constexpr char kDisparity[] = "disp0GT.pfm";
constexpr char kMask[] = "mask0nocc.png";
constexpr char kCalibration[] = "calib.txt";

bool IsScene(const fs::path& folder) {
  return fs::exists(folder / kLeft) || fs::exists(folder / kDisparity);
}

std::vector<std::string> ScenesIn(const fs::path& folder) {
  if (!fs::is_directory(folder)) {
    throw std::invalid_argument(folder.string() + ": there is no such folder.");
  }
  if (IsScene(folder)) return {folder.string()};
  std::vector<std::string> scenes;
  for (const fs::directory_entry& entry : fs::directory_iterator(folder)) {
    if (entry.is_directory() && IsScene(entry.path())) scenes.push_back(entry.path().string());
  }
  if (scenes.empty()) {
    throw std::invalid_argument(folder.string() + ": neither a scene nor a folder of scenes; " +
                                kLeft + ", " + kRight + " and " + kDisparity + " are expected.");
  }
  std::sort(scenes.begin(), scenes.end());
  return scenes;
}

void CheckSize(const fs::path& file, cv::Size size, const cv::Mat& left) {
  if (size == left.size()) return;
  throw std::invalid_argument(file.string() + ": " + std::to_string(size.width) + " x " +
                              std::to_string(size.height) + " pixels, but the left image has " +
                              std::to_string(left.cols) + " x " + std::to_string(left.rows) + ".");
}

std::string NameOf(const fs::path& folder) {
  // "scene/" has an empty file name; its parent is "scene".
  return (folder.has_filename() ? folder : folder.parent_path()).filename().string();
}

}  // namespace

std::vector<std::string> FindScenes(const std::vector<std::string>& folders) {
  std::vector<std::string> scenes;
  for (const std::string& folder : folders) {
    const std::vector<std::string> found = ScenesIn(folder);
    scenes.insert(scenes.end(), found.begin(), found.end());
  }
  return scenes;
}

StereoScene LoadScene(const std::string& folder) {
  const fs::path path(folder);
  StereoScene scene;
  scene.name = NameOf(path);
  scene.left = LoadImage((path / kLeft).string());
  scene.right = LoadImage((path / kRight).string());
  CheckPair(scene.left, (path / kLeft).string(), scene.right, (path / kRight).string());
  scene.disparity = ReadPfm((path / kDisparity).string());
  CheckSize(path / kDisparity, scene.disparity.size(), scene.left);
  if (scene.disparity.channels() != 1) {
    throw std::invalid_argument((path / kDisparity).string() +
                                ": three channels found, one is expected of disparities.");
  }
  if (fs::exists(path / kMask)) {
    scene.mask = LoadImage((path / kMask).string());
    CheckSize(path / kMask, scene.mask.size(), scene.left);
    if (scene.mask.type() != CV_8UC1) {
      throw std::invalid_argument((path / kMask).string() + ": 8 bit gray is expected of a mask.");
    }
  }
  if (fs::exists(path / kCalibration)) {
    scene.calibration = ReadCalibration((path / kCalibration).string());
  }
  return scene;
}

void SaveScene(const std::string& folder, const StereoScene& scene) {
  const fs::path path(folder);
  fs::create_directories(path);
  SaveImage((path / kLeft).string(), scene.left);
  SaveImage((path / kRight).string(), scene.right);
  WritePfm((path / kDisparity).string(), scene.disparity);
  if (!scene.mask.empty()) SaveImage((path / kMask).string(), scene.mask);
  if (scene.calibration) WriteCalibration((path / kCalibration).string(), *scene.calibration);
}

}  // namespace stereo_sgmp
