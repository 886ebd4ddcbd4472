#include "evaluation/datasets/middlebury_pictures.h"

#include <cmath>
#include <cstdint>

#include "evaluation/datasets/scene_files.h"
#include "io/disparity_file.h"

namespace stereo_sgmp {

namespace fs = std::filesystem;

namespace {

// The file `stem` of any picture format of the data sets.
fs::path Picture(const fs::path& folder, const std::string& stem) {
  const std::string png = stem + ".png";
  const std::string ppm = stem + ".ppm";
  const std::string pgm = stem + ".pgm";
  return FirstFile(folder, {png.c_str(), ppm.c_str(), pgm.c_str()});
}

// What the files of one generation of data sets are called, without their extensions.
struct Stems {
  const char* left;
  const char* right;
  const char* left_truth;
  const char* right_truth;
};
constexpr Stems kStems2003 = {"im2", "im6", "disp2", "disp6"};
constexpr Stems kStems2006 = {"view1", "view5", "disp1", "disp5"};

double Scale2003(int width) {
  return width < 450 ? 8.0 : width < 900 ? 4.0 : width < 1800 ? 2.0 : 1.0;
}
double Scale2006(int width) { return width <= 550 ? 3.0 : width <= 1000 ? 2.0 : 1.0; }

std::vector<std::string> FindByStems(const fs::path& path, const Stems& stems) {
  if (Picture(path, stems.left).empty() || Picture(path, stems.left_truth).empty()) return {};
  return {path.string()};
}

cv::Mat ReadTruth(const fs::path& file, double scale, const StereoScene& scene) {
  cv::Mat truth = ReadDisparity(file.string(), scale);
  CheckSize(file, truth, scene);
  return truth;
}

StereoScene LoadByStems(const fs::path& path, const Stems& stems, double (*scale_of)(int),
                        const DatasetOptions& options) {
  StereoScene scene;
  const fs::path right = Picture(path, stems.right);
  LoadImages(Picture(path, stems.left),
             right.empty() ? path / (std::string(stems.right) + ".png") : right, &scene);
  const double scale = options.truth_scale > 0.0 ? options.truth_scale : scale_of(scene.left.cols);
  scene.disparity = ReadTruth(Picture(path, stems.left_truth), scale, scene);
  const fs::path right_truth = Picture(path, stems.right_truth);
  if (!right_truth.empty()) {
    scene.mask = SeenByBoth(scene.disparity, ReadTruth(right_truth, scale, scene));
  }
  return scene;
}

std::vector<std::string> Find2003(const fs::path& path) { return FindByStems(path, kStems2003); }
std::vector<std::string> Find2006(const fs::path& path) { return FindByStems(path, kStems2006); }

StereoScene Load2003(const fs::path& path, const DatasetOptions& options) {
  return LoadByStems(path, kStems2003, Scale2003, options);
}

StereoScene Load2006(const fs::path& path, const DatasetOptions& options) {
  return LoadByStems(path, kStems2006, Scale2006, options);
}

}  // namespace

const SceneLayout kMiddlebury2003Layout = {"im2, im6 and disp2 (.png, .ppm, .pgm)", Find2003,
                                           Load2003};
const SceneLayout kMiddlebury2006Layout = {"view1.png, view5.png and disp1.png", Find2006,
                                           Load2006};

cv::Mat SeenByBoth(const cv::Mat& left_truth, const cv::Mat& right_truth) {
  constexpr float kTolerance = 1.0F;  // pixels; the pictures hold whole numbers
  cv::Mat mask = cv::Mat::zeros(left_truth.size(), CV_8U);
  for (int y = 0; y < mask.rows; ++y) {
    for (int x = 0; x < mask.cols; ++x) {
      const float d = left_truth.at<float>(y, x);
      if (!std::isfinite(d)) continue;
      const int match = x - static_cast<int>(std::lround(d));
      const bool seen = match >= 0 && match < mask.cols &&
                        std::abs(right_truth.at<float>(y, match) - d) <= kTolerance;
      mask.at<std::uint8_t>(y, x) = seen ? 255 : 128;
    }
  }
  return mask;
}

}  // namespace stereo_sgmp
