// Writes a generated stereo scene with exact ground truth.
#include <cstdint>
#include <filesystem>
#include <limits>
#include <sstream>
#include <string>
#include <vector>

#include "evaluation/dataset.h"
#include "io/file_io.h"
#include "io/image.h"
#include "io/pfm.h"
#include "scene/generated_scene.h"
#include "tools/tool_main.h"

namespace stereo_sgmp {
namespace {

constexpr char kDescription[] =
    "Writes a generated stereo scene with exact ground truth: im0.png, im1.png, disp0GT.pfm,\n"
    "mask0nocc.png and calib.txt, as evaluate and match read them, and\n"
    "  normals0.pfm  unit normals, x right, y down, z forward, towards the camera; 0 for nothing\n"
    "  labels0.png   16 bit: the number of the plane that the pixel shows; 0 for none\n"
    "  planes.txt    a line \"a b c\" for plane 1, 2, ...: its disparity is a x + b y + c\n"
    "Examples:\n"
    "  render_scene corridor out/corridor\n"
    "  render_scene room out/room --width 2880 --height 1980 --disparities 290\n"
    "  render_scene fence out/fence --gain 1.1 --vertical-offset 0.5 --seed 7";

struct Arguments {
  std::string kind;
  std::string folder;
  int width = 1280;
  int height = 720;
  int disparities = 128;
  std::uint64_t seed = 1;
  SceneQuality quality;
};

void AddFlags(CLI::App* app, Arguments* a) {
  app->add_option("kind", a->kind,
                  "corridor, slanted_plane, room, fronto_parallel, fence or curved")
      ->required();
  app->add_option("folder", a->folder, "Folder to write to; created if needed")->required();
  app->add_option("--width", a->width, "Width, pixels (1280)")->check(CLI::Range(16, 8192));
  app->add_option("--height", a->height, "Height, pixels (720)")->check(CLI::Range(1, 8192));
  app->add_option("--disparities", a->disparities,
                  "All disparities lie below this; at most half the width (128)");
  app->add_option("--seed", a->seed, "The same seed makes the same scene (1)");
  SceneQuality* quality = &a->quality;
  app->add_option("--contrast", quality->contrast, "Factor on the textures' contrast (1)")
      ->check(CLI::Range(0.0, 10.0));
  app->add_option("--noise", quality->noise, "Sensor noise, gray levels (1)")
      ->check(CLI::Range(0.0, 100.0));
  app->add_option("--blur", quality->blur, "Blur of both lenses, standard deviation, pixels (0.5)")
      ->check(CLI::Range(0.0, 100.0));
  app->add_option("--vignetting", quality->vignetting,
                  "Share of the light that the left image loses in its corners (0.1)")
      ->check(CLI::Range(0.0, 1.0));
  app->add_option("--right-vignetting", quality->right_vignetting,
                  "The same of the right image (0.1)")
      ->check(CLI::Range(0.0, 1.0));
  app->add_option("--gain", quality->gain, "Exposure of the right image: factor (1)")
      ->check(CLI::Range(0.1, 10.0));
  app->add_option("--offset", quality->offset, "Exposure of the right image: gray levels (0)")
      ->check(CLI::Range(-255.0, 255.0));
  app->add_option("--vertical-scale", quality->vertical_scale,
                  "Rectification residual: row y of the left image is row a y + b of the right "
                  "one, a (1)")
      ->check(CLI::Range(0.9, 1.1));
  app->add_option("--vertical-offset", quality->vertical_offset, "The same, b, pixels (0)")
      ->check(CLI::Range(-100.0, 100.0));
}

std::string PlaneLines(const std::vector<DisparityPlane>& planes) {
  std::ostringstream lines;
  lines.precision(std::numeric_limits<double>::max_digits10);
  for (const DisparityPlane& plane : planes) {
    lines << plane.a << ' ' << plane.b << ' ' << plane.c << '\n';
  }
  return lines.str();
}

void Run(const Arguments& a) {
  const cv::Size size(a.width, a.height);
  const GeneratedScene generated =
      MakeScene(SceneKindFromName(a.kind), size, a.disparities, a.quality, a.seed);
  StereoScene scene;
  scene.left = generated.left;
  scene.right = generated.right;
  scene.disparity = generated.disparity;
  scene.mask = generated.mask;
  scene.calibration = Calibration{generated.camera, size, generated.num_disparities};
  SaveScene(a.folder, scene);
  const std::filesystem::path folder(a.folder);
  WritePfm((folder / "normals0.pfm").string(), generated.normals);
  cv::Mat labels;
  generated.labels.convertTo(labels, CV_16U, 1.0, 1.0);
  SaveImage((folder / "labels0.png").string(), labels);
  WriteFile((folder / "planes.txt").string(), PlaneLines(generated.planes));
}

}  // namespace
}  // namespace stereo_sgmp

int main(int argc, char** argv) {
  stereo_sgmp::Arguments arguments;
  CLI::App app(stereo_sgmp::kDescription, "render_scene");
  stereo_sgmp::AddFlags(&app, &arguments);
  return stereo_sgmp::RunTool(argc, argv, &app, [&] { stereo_sgmp::Run(arguments); });
}
