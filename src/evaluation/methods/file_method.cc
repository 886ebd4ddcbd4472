#include "evaluation/methods/file_method.h"

#include <cmath>
#include <filesystem>
#include <stdexcept>
#include <vector>

#include <opencv2/imgproc.hpp>

#include "evaluation/methods/sparse_result.h"
#include "io/disparity_file.h"

namespace stereo_sgmp {

namespace fs = std::filesystem;

namespace {

std::string NameOfFolder(const fs::path& folder) {
  if (!fs::is_directory(folder)) {
    throw std::invalid_argument(folder.string() + ": there is no such folder of disparity maps.");
  }
  // "maps/." and "." have a name once they are written out.
  const fs::path whole = fs::canonical(folder);
  return whole.filename().string();
}

bool IsSubmission(const fs::path& file) {
  const std::string name = file.filename().string();
  return name.rfind("disp0", 0) == 0 && file.extension() == ".pfm" && name != "disp0GT.pfm";
}

std::vector<fs::path> Candidates(const fs::path& folder, const std::string& scene) {
  std::vector<fs::path> files;
  for (const char* extension : {".pfm", ".png"}) {
    const fs::path file = folder / (scene + extension);
    if (fs::exists(file)) files.push_back(file);
  }
  if (!fs::is_directory(folder / scene)) return files;
  for (const fs::directory_entry& entry : fs::directory_iterator(folder / scene)) {
    if (IsSubmission(entry.path())) files.push_back(entry.path());
  }
  return files;
}

cv::Mat ScaledUp(const cv::Mat& map, cv::Size size, const std::string& file) {
  if (map.size() == size) return map;
  const double ratio = static_cast<double>(size.width) / map.cols;
  // The height of a reduced image is rounded, up or down.
  const bool fits = ratio > 1.0 && std::abs(map.rows - size.height / ratio) <= 1.0;
  if (!fits) {
    throw std::invalid_argument(file + ": " + std::to_string(map.cols) + " x " +
                                std::to_string(map.rows) + " pixels, but the left image has " +
                                std::to_string(size.width) + " x " + std::to_string(size.height) +
                                "; that size or a fraction of it is expected.");
  }
  cv::Mat scaled;
  cv::resize(map, scaled, size, 0.0, 0.0, cv::INTER_NEAREST);
  return scaled * ratio;
}

}  // namespace

FileMethod::FileMethod(const std::string& folder)
    : StereoMethod(NameOfFolder(folder)), folder_(folder) {}

std::string FileMethod::FileOf(const std::string& scene) const {
  const std::vector<fs::path> files = Candidates(folder_, scene);
  if (files.size() <= 1) return files.empty() ? "" : files.front().string();
  throw std::invalid_argument(files[0].string() + " and " + files[1].string() +
                              " are both disparity maps of the scene " + scene +
                              "; one is expected.");
}

std::string FileMethod::Missing(const StereoScene& scene) const {
  if (!FileOf(scene.name).empty()) return {};
  return "a disparity map " + (fs::path(folder_) / (scene.name + ".pfm")).string();
}

MethodResult FileMethod::Run(const StereoScene& scene, int /*num_disparities*/) {
  const std::string file = FileOf(scene.name);
  return SparseResult(ScaledUp(ReadDisparity(file, 0.0), scene.left.size(), file));
}

}  // namespace stereo_sgmp
