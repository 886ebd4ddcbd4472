// Makes a normal map from a disparity map.
#include <stdexcept>
#include <string>

#include "geometry/normals_from_disparity.h"
#include "io/calib.h"
#include "io/disparity_file.h"
#include "io/file_io.h"
#include "io/pfm.h"
#include "tools/tool_main.h"

namespace stereo_sgmp {
namespace {

constexpr char kDescription[] =
    "Writes the normals of a disparity map, for match --normals: .pfm of three channels, unit\n"
    "vectors towards the camera, x right, y down, z forward, zero where there is none.\n"
    "Examples:\n"
    "  make_normals disp0GT.pfm --calib calib.txt --output normals.pfm\n"
    "  make_normals disp1.png --scale 4 --calib calib.txt --output normals.pfm\n"
    "  make_normals depth.png --depth --calib calib.txt --output normals.pfm";

struct Arguments {
  std::string disparity;
  std::string calib;
  std::string output;
  double scale = 0.0;
  bool depth = false;
};

void AddFlags(CLI::App* app, Arguments* a) {
  app->add_option("disparity", a->disparity,
                  "Disparities: .pfm (pixels; inf or nan: unknown), 16-bit PNG (/ 256) or 8-bit "
                  "PNG, 0 unknown")
      ->required();
  app->add_option("--calib", a->calib, "Middlebury calib.txt: the camera")->required();
  app->add_option("--output", a->output, "Write the normals (PFM)")->required();
  CLI::Option* scale =
      app->add_option("--scale", a->scale,
                      "Disparity = value / this, in place of the scale of the file's format")
          ->check(CLI::Range(0.001, 100000.0));
  app->add_flag("--depth", a->depth,
                "The file holds depths: .pfm in metres or 16-bit PNG in millimetres")
      ->excludes(scale);
}

void CheckSize(const Arguments& a, cv::Size map, cv::Size calibrated) {
  if (calibrated.empty() || map == calibrated) return;
  throw std::invalid_argument(
      a.calib + ": it is for images of " + std::to_string(calibrated.width) + " x " +
      std::to_string(calibrated.height) + " pixels, but " + a.disparity + " has " +
      std::to_string(map.width) + " x " + std::to_string(map.height) + ".");
}

void Run(const Arguments& a) {
  CheckWritable(a.output);
  const Calibration calibration = ReadCalibration(a.calib);
  const cv::Mat disparity = a.depth ? ReadDepthAsDisparity(a.disparity, calibration.camera)
                                    : ReadDisparity(a.disparity, a.scale);
  CheckSize(a, disparity.size(), calibration.size);
  WritePfm(a.output, NormalsFromDisparity(disparity, calibration.camera));
}

}  // namespace
}  // namespace stereo_sgmp

int main(int argc, char** argv) {
  stereo_sgmp::Arguments arguments;
  CLI::App app(stereo_sgmp::kDescription, "make_normals");
  stereo_sgmp::AddFlags(&app, &arguments);
  return stereo_sgmp::RunTool(argc, argv, &app, [&] { stereo_sgmp::Run(arguments); });
}
