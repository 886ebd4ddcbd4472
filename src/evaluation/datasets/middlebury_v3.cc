#include "evaluation/datasets/middlebury_v3.h"

#include <stdexcept>

#include "evaluation/datasets/scene_files.h"
#include "io/disparity_file.h"
#include "io/image.h"
#include "io/normals_file.h"
#include "io/pfm.h"

namespace stereo_sgmp {

namespace fs = std::filesystem;

namespace {

constexpr char kLeft[] = "im0.png";
constexpr char kRight[] = "im1.png";
constexpr char kTruth[] = "disp0GT.pfm";
constexpr char kTruthOfDownloads[] = "disp0.pfm";  // of the data sets, apart from the evaluation
constexpr char kMask[] = "mask0nocc.png";
constexpr char kCalibration[] = "calib.txt";
constexpr char kNormals[] = "normals0.pfm";

std::vector<std::string> Find(const fs::path& path) {
  if (FirstFile(path, {kLeft, kTruth, kTruthOfDownloads}).empty()) return {};
  return {path.string()};
}

cv::Mat ReadTruth(const fs::path& file, const StereoScene& scene) {
  cv::Mat truth = ReadDisparity(file.string(), 1.0);
  CheckSize(file, truth, scene);
  return truth;
}

cv::Mat ReadMask(const fs::path& file, const StereoScene& scene) {
  cv::Mat mask = LoadImage(file.string());
  CheckSize(file, mask, scene);
  if (mask.type() == CV_8UC1) return mask;
  throw std::invalid_argument(file.string() + ": 8 bit gray is expected of a mask.");
}

StereoScene Load(const fs::path& path, const DatasetOptions& /*options*/) {
  StereoScene scene;
  LoadImages(path / kLeft, path / kRight, &scene);
  const fs::path truth = FirstFile(path, {kTruth, kTruthOfDownloads});
  scene.disparity = ReadTruth(truth.empty() ? path / kTruth : truth, scene);
  if (fs::exists(path / kMask)) scene.mask = ReadMask(path / kMask, scene);
  if (fs::exists(path / kNormals)) {
    scene.normals = ReadNormals((path / kNormals).string());
    CheckSize(path / kNormals, scene.normals, scene);
  }
  if (fs::exists(path / kCalibration)) {
    scene.calibration = ReadCalibration((path / kCalibration).string());
  }
  return scene;
}

}  // namespace

const SceneLayout kMiddleburyV3Layout = {"im0.png, im1.png and disp0GT.pfm", Find, Load};

void SaveMiddleburyV3(const fs::path& folder, const StereoScene& scene) {
  fs::create_directories(folder);
  SaveImage((folder / kLeft).string(), scene.left);
  SaveImage((folder / kRight).string(), scene.right);
  WritePfm((folder / kTruth).string(), scene.disparity);
  if (!scene.mask.empty()) SaveImage((folder / kMask).string(), scene.mask);
  if (!scene.normals.empty()) WritePfm((folder / kNormals).string(), scene.normals);
  if (scene.calibration) WriteCalibration((folder / kCalibration).string(), *scene.calibration);
}

}  // namespace stereo_sgmp
