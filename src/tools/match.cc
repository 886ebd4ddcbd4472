// Matches one rectified stereo pair.
#include <algorithm>
#include <limits>
#include <optional>
#include <stdexcept>
#include <string>
#include <vector>

#include "io/calib.h"
#include "io/color_map.h"
#include "io/file_io.h"
#include "io/image.h"
#include "io/pcl/point_cloud_io.h"
#include "io/pfm.h"
#include "io/prior_picture.h"
#include "stereo_sgmp/matcher.h"
#include "stereo_sgmp/point_cloud.h"
#include "tools/match_statistics.h"
#include "tools/matcher_flags.h"
#include "tools/tool_main.h"

namespace stereo_sgmp {
namespace {

constexpr char kDescription[] =
    "Matches a rectified stereo pair by semi-global matching with surface orientation priors.\n"
    "Examples:\n"
    "  match left.png right.png --disparity d.pfm --num-disparities 128 --color d.png\n"
    "  match im0.png im1.png --calib calib.txt --disparity d.pfm --cloud points.ply\n"
    "  match im0.png im1.png --calib calib.txt --disparity d.pfm --preset paper --variant epi\n"
    "  match im0.png im1.png --calib calib.txt --disparity d.pfm --stats times.json --repeat 9\n"
    "Options apply in the order preset, options file, calibration, flags; the last one counts.";

struct Arguments {
  MatcherFlags matcher;
  std::string left;
  std::string right;
  std::string disparity;
  std::string confidence;
  std::string calib;
  std::string color;
  std::string cloud;
  std::string prior_image;
  std::string stats;
  std::optional<int> min_disparity;
  std::optional<int> num_disparities;
  bool dense = false;
  bool raw = false;
  int repeat = 1;
};

struct Inputs {
  cv::Mat left;
  cv::Mat right;
  std::optional<Calibration> calibration;
};

void AddInputs(CLI::App* app, Arguments* a) {
  app->add_option("left", a->left, "Left image: 8 or 16 bit, gray or colour")->required();
  app->add_option("right", a->right, "Right image, of the same size and type")->required();
  CLI::Option* calib = app->add_option(
      "--calib", a->calib, "Middlebury calib.txt: the camera, and ndisp for --num-disparities");
  app->add_option_function<int>(
      "--min-disparity", [a](int value) { a->min_disparity = value; },
      "Smallest disparity searched, pixels; may be negative");
  app->add_option_function<int>(
      "--num-disparities", [a](int value) { a->num_disparities = value; },
      "Number of disparities searched. Without it and --calib: the preset's, at most the width "
      "of the image");
  a->matcher.AddTo(app);
  app->add_option("--repeat", a->repeat, "Match the pair so many times, for --stats")
      ->check(CLI::Range(1, 1000000));
  app->add_option("--cloud", a->cloud, "Write the point cloud (PLY, metres); needs --calib")
      ->needs(calib);
}

void AddOutputs(CLI::App* app, Arguments* a) {
  app->add_option("--disparity", a->disparity,
                  "Write the filtered disparities (PFM); inf where they are invalid")
      ->required();
  CLI::Option* dense = app->add_flag(
      "--dense", a->dense, "Let --disparity have a value at every pixel: holes filled, smoothed");
  app->add_flag("--raw", a->raw,
                "Let --disparity have the winner of every pixel, neither filtered nor filled")
      ->excludes(dense);
  app->add_option("--confidence", a->confidence, "Write the confidence, 0..1 (PFM)");
  app->add_option("--color", a->color, "Write the disparities as a colour picture");
  app->add_option("--prior-image", a->prior_image,
                  "Write the plane prior as a picture: a hue per plane, lines where it steps");
  app->add_option("--stats", a->stats, "Write times, memory and counts (JSON)");
}

void CheckOutputs(const Arguments& a) {
  for (const std::string& path :
       {a.disparity, a.confidence, a.color, a.cloud, a.prior_image, a.stats}) {
    if (!path.empty()) CheckWritable(path);
  }
  for (const std::string& path : {a.color, a.prior_image}) {
    if (!path.empty()) CheckImageName(path);
  }
}

Inputs Load(const Arguments& a) {
  Inputs inputs;
  inputs.left = LoadImage(a.left);
  inputs.right = LoadImage(a.right);
  CheckPair(inputs.left, a.left, inputs.right, a.right);
  if (a.calib.empty()) return inputs;
  inputs.calibration = ReadCalibration(a.calib);
  const cv::Size size = inputs.calibration->size;
  if (!size.empty() && size != inputs.left.size()) {
    throw std::invalid_argument(a.calib + ": it is for images of " + std::to_string(size.width) +
                                " x " + std::to_string(size.height) + " pixels, but " + a.left +
                                " has " + std::to_string(inputs.left.cols) + " x " +
                                std::to_string(inputs.left.rows) + ".");
  }
  return inputs;
}

Options MakeOptions(const Arguments& a, const Inputs& inputs) {
  Options options = a.matcher.ToOptions();
  if (a.min_disparity) options.min_disparity = *a.min_disparity;
  if (a.num_disparities) {
    options.num_disparities = *a.num_disparities;
  } else if (inputs.calibration && inputs.calibration->num_disparities > 0) {
    options.num_disparities = inputs.calibration->num_disparities;
  } else {
    options.num_disparities = std::min(options.num_disparities, inputs.left.cols);
  }
  return options;
}

cv::Mat WantedDisparity(const Arguments& a, const MatchResult& result) {
  if (a.raw) return result.raw;
  if (a.dense) return result.dense;
  cv::Mat disparity;
  FilteredDisparity(result, std::numeric_limits<float>::infinity(), &disparity);
  return disparity;
}

void WriteCloud(const std::string& path, const Inputs& inputs, const MatchResult& result) {
  PointCloud cloud;
  ComputePointCloud(result, inputs.calibration->camera, inputs.left, CloudOptions(), &cloud);
  SavePly(path, cloud);
}

void WriteOutputs(const Arguments& a, const Inputs& inputs, const Options& options,
                  const MatchResult& result, const std::vector<MatchStatistics>& frames) {
  const cv::Mat disparity = WantedDisparity(a, result);
  WritePfm(a.disparity, disparity);
  if (!a.confidence.empty()) WritePfm(a.confidence, result.confidence);
  if (!a.color.empty()) {
    const int last = options.min_disparity + options.num_disparities - 1;
    SaveImage(a.color, ColorDisparity(disparity, options.min_disparity, last));
  }
  if (!a.prior_image.empty()) {
    SaveImage(a.prior_image, PriorPicture(result.priors, inputs.left.size()));
  }
  if (!a.cloud.empty()) WriteCloud(a.cloud, inputs, result);
  if (!a.stats.empty()) WriteFile(a.stats, StatisticsJson(frames, options, inputs.left.size()));
}

void Run(const Arguments& a) {
  CheckOutputs(a);
  const Inputs inputs = Load(a);
  const Options options = MakeOptions(a, inputs);
  Matcher matcher(options);
  MatchResult result;
  std::vector<MatchStatistics> frames;
  for (int i = 0; i < a.repeat; ++i) {
    matcher.Match(inputs.left, inputs.right, &result);
    frames.push_back(result.statistics);
  }
  WriteOutputs(a, inputs, options, result, frames);
}

}  // namespace
}  // namespace stereo_sgmp

int main(int argc, char** argv) {
  stereo_sgmp::Arguments arguments;
  CLI::App app(stereo_sgmp::kDescription, "match");
  stereo_sgmp::AddInputs(&app, &arguments);
  stereo_sgmp::AddOutputs(&app, &arguments);
  return stereo_sgmp::RunTool(argc, argv, &app, [&] { stereo_sgmp::Run(arguments); });
}
