// Matches one rectified stereo pair.
#include <iostream>
#include <limits>
#include <optional>
#include <string>
#include <vector>

#include "io/color_map.h"
#include "io/cost_volume_file.h"
#include "io/file_io.h"
#include "io/image.h"
#include "io/pcl/point_cloud_io.h"
#include "io/pfm.h"
#include "io/prior_picture.h"
#include "stereo_sgmp/matcher.h"
#include "stereo_sgmp/point_cloud.h"
#include "tools/match_input_flags.h"
#include "tools/match_statistics.h"
#include "tools/matcher_flags.h"
#include "tools/pair_flags.h"
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
    "  match im0.png im1.png --disparity d.pfm --variant gs --prior-surface disp0GT.pfm\n"
    "  match im0.png im1.png --disparity d.pfm --cost im0.acrt --num-disparities 145\n"
    "Options apply in the order preset, options file, calibration, flags; the last one counts.";

struct Arguments {
  PairFlags pair;
  MatchInputFlags inputs;
  MatcherFlags matcher;
  std::string disparity;
  std::string confidence;
  std::string color;
  std::string cloud;
  std::string prior_image;
  std::string stats;
  bool dense = false;
  bool raw = false;
  int repeat = 1;
};

void AddInputs(CLI::App* app, Arguments* a) {
  a->pair.AddTo(app);
  a->inputs.AddTo(app, a->pair.calib_flag());
  a->matcher.AddTo(app, MatcherFlags::CostFlag::kKindOrVolume);
  app->add_option("--repeat", a->repeat, "Match the pair so many times, for --stats")
      ->check(CLI::Range(1, 1000000));
  app->add_option("--cloud", a->cloud, "Write the point cloud (PLY, metres); needs --calib")
      ->needs(a->pair.calib_flag());
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

Options MakeOptions(const Arguments& a, const LoadedPair& pair) {
  Options options = a.matcher.ToOptions();
  const std::string volume = a.matcher.CostVolumeFile();
  a.pair.SetRange(pair, volume.empty() ? std::nullopt : ReadCostVolumeShape(volume), &options);
  return options;
}

cv::Mat WantedDisparity(const Arguments& a, const MatchResult& result) {
  if (a.raw) return result.raw;
  if (a.dense) return result.dense;
  cv::Mat disparity;
  FilteredDisparity(result, std::numeric_limits<float>::infinity(), &disparity);
  return disparity;
}

void WriteCloud(const std::string& path, const LoadedPair& pair, const MatchResult& result) {
  PointCloud cloud;
  ComputePointCloud(result, pair.calibration->camera, pair.left, CloudOptions(), &cloud);
  SavePly(path, cloud);
}

void WriteOutputs(const Arguments& a, const LoadedPair& pair, const Options& options,
                  const MatchResult& result, const std::vector<MatchStatistics>& frames) {
  const cv::Mat disparity = WantedDisparity(a, result);
  WritePfm(a.disparity, disparity);
  if (!a.confidence.empty()) WritePfm(a.confidence, result.confidence);
  if (!a.color.empty()) {
    const int last = options.min_disparity + options.num_disparities - 1;
    SaveImage(a.color, ColorDisparity(disparity, options.min_disparity, last));
  }
  if (!a.prior_image.empty()) {
    SaveImage(a.prior_image, PriorPicture(result.priors, pair.left.size()));
  }
  if (!a.cloud.empty()) WriteCloud(a.cloud, pair, result);
  if (!a.stats.empty()) {
    WriteFile(a.stats, StatisticsJson(frames, result.priors, options, pair.left.size()));
  }
}

void Run(const Arguments& a) {
  CheckOutputs(a);
  const LoadedPair pair = a.pair.Load();
  const Options options = MakeOptions(a, pair);
  Matcher matcher(options);  // refuses wrong options before large files are read
  const LoadedInputs loaded = a.inputs.Load(pair, options, a.matcher.CostVolumeFile());
  MatchResult result;
  std::vector<MatchStatistics> frames;
  for (int i = 0; i < a.repeat; ++i) {
    matcher.Match(pair.left, pair.right, loaded.inputs, &result);
    frames.push_back(result.statistics);
  }
  const std::string& note = result.priors.note;
  if (!note.empty()) std::cerr << "match: " << note << '\n';
  WriteOutputs(a, pair, options, result, frames);
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
