#include "tools/match_input_flags.h"

#include <stdexcept>
#include <string>

#include "io/cost_volume_file.h"
#include "io/disparity_file.h"
#include "io/image.h"
#include "io/normals_file.h"

namespace stereo_sgmp {
namespace {

void CheckSize(const std::string& path, cv::Size size, const LoadedPair& pair) {
  if (size == pair.left.size()) return;
  throw std::invalid_argument(path + ": " + std::to_string(size.width) + " x " +
                              std::to_string(size.height) + " pixels, but the images have " +
                              std::to_string(pair.left.cols) + " x " +
                              std::to_string(pair.left.rows) + ".");
}

std::unique_ptr<CostVolume> LoadCosts(const std::string& path, const LoadedPair& pair,
                                      const Options& options) {
  auto volume = std::make_unique<CostVolume>();
  if (const std::optional<CostVolume> shape = ReadCostVolumeShape(path)) {
    *volume = *shape;
  } else {
    volume->width = pair.left.cols;
    volume->height = pair.left.rows;
    volume->disparities = options.num_disparities;
    volume->min_disparity = options.min_disparity;
  }
  ReadCosts(path, volume.get());
  return volume;
}

}  // namespace

void MatchInputFlags::AddTo(CLI::App* app, CLI::Option* calib) {
  CLI::Option* surface = app->add_option(
      "--prior-surface", surface_,
      "Disparity surface to stay parallel to, of the size of the images, for --variant gs and gp: "
      ".pfm (pixels; inf or nan: unknown), 16-bit PNG (/ 256) or 8-bit PNG, 0 unknown");
  CLI::Option* scale =
      app->add_option("--prior-scale", scale_,
                      "Disparity = value / this, in place of the scale of the file's format")
          ->needs(surface)
          ->check(CLI::Range(0.001, 100000.0));
  app->add_flag("--prior-depth", surface_is_depth_,
                "Let --prior-surface be depths: .pfm in metres or 16-bit PNG in millimetres; needs "
                "--calib")
      ->needs(surface)
      ->needs(calib)
      ->excludes(scale);
  CLI::Option* normals =
      app->add_option("--normals", normals_,
                      "Unit normals, for --variant gni and gnv: .pfm of three channels, x right, y "
                      "down, z forward; zero or nan: unknown");
  app->add_option("--discontinuities", discontinuities_,
                  "Where depth is known to jump, for --normals: picture of 8 bit gray, not 0 at "
                  "both pixels beside a jump. Without it, only where normals change abruptly")
      ->needs(normals);
}

cv::Mat MatchInputFlags::LoadSurface(const LoadedPair& pair) const {
  return surface_is_depth_ ? ReadDepthAsDisparity(surface_, pair.calibration->camera)
                           : ReadDisparity(surface_, scale_);
}

cv::Mat MatchInputFlags::LoadDiscontinuities(const LoadedPair& pair) const {
  cv::Mat map = LoadImage(discontinuities_);
  if (map.type() != CV_8UC1) {
    throw std::invalid_argument(discontinuities_ +
                                ": discontinuities in depth are expected as a picture of 8 bit "
                                "gray; this one has " +
                                std::to_string(map.channels()) + " channels of " +
                                std::to_string(8 * map.elemSize1()) + " bit.");
  }
  CheckSize(discontinuities_, map.size(), pair);
  return map;
}

LoadedInputs MatchInputFlags::Load(const LoadedPair& pair, const Options& options,
                                   const std::string& cost_volume) const {
  LoadedInputs loaded;
  if (pair.calibration) loaded.inputs.camera = pair.calibration->camera;
  if (!surface_.empty()) {
    loaded.inputs.surface = LoadSurface(pair);
    CheckSize(surface_, loaded.inputs.surface.size(), pair);
  }
  if (!normals_.empty()) {
    loaded.inputs.normals = ReadNormals(normals_);
    CheckSize(normals_, loaded.inputs.normals.size(), pair);
  }
  if (!discontinuities_.empty()) loaded.inputs.discontinuities = LoadDiscontinuities(pair);
  if (!cost_volume.empty()) {
    loaded.costs = LoadCosts(cost_volume, pair, options);
    loaded.inputs.costs = loaded.costs.get();
  }
  return loaded;
}

}  // namespace stereo_sgmp
