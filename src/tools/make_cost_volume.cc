// Writes the package's own matching costs as a cost volume.
#include <cstddef>
#include <cstdint>
#include <optional>
#include <string>

#include "alignment/rig_alignment.h"
#include "alignment/warp_rows.h"
#include "common/aligned_buffer.h"
#include "common/thread_pool.h"
#include "cost/cost_computer.h"
#include "images/image_pair.h"
#include "io/cost_volume_file.h"
#include "io/file_io.h"
#include "matcher/coarse_pass.h"
#include "stereo_sgmp/option_fields.h"
#include "tools/matcher_flags.h"
#include "tools/pair_flags.h"
#include "tools/tool_main.h"

namespace stereo_sgmp {
namespace {

constexpr char kDescription[] =
    "Writes the matching costs of a stereo pair as match computes them, after the alignment, in\n"
    "the format of mc-cnn (.bin) or LocalExp (.acrt), with its shape in FILE.shape. match --cost\n"
    "FILE then gives what match --cost ncc does, with the same flags otherwise.\n"
    "Examples:\n"
    "  make_cost_volume left.png right.png --num-disparities 128 --output costs.bin\n"
    "  make_cost_volume im0.png im1.png --calib calib.txt --cost census --output costs.acrt";

struct Arguments {
  PairFlags pair;
  MatcherFlags matcher{"ncc"};
  std::string output;
};

void AddFlags(CLI::App* app, Arguments* a) {
  a->pair.AddTo(app);
  a->matcher.AddTo(app);
  app->add_option("--output", a->output, "Write the cost volume (.bin or .acrt)")->required();
}

// The costs of `rows` without their padding.
CostVolume Copied(const CostRows& rows) {
  const VolumeShape& shape = rows.shape();
  CostVolume volume;
  volume.width = shape.width;
  volume.height = shape.height;
  volume.disparities = shape.disparities;
  volume.min_disparity = shape.min_disparity;
  volume.costs.reserve(static_cast<std::size_t>(shape.width) *
                       static_cast<std::size_t>(shape.height) *
                       static_cast<std::size_t>(shape.disparities));
  AlignedBuffer<std::uint8_t> scratch;
  scratch.Resize(static_cast<std::size_t>(shape.width) * static_cast<std::size_t>(shape.Stride()));
  for (int y = 0; y < shape.height; ++y) {
    const std::uint8_t* costs = rows.Row(y, 0, shape.width, scratch.data());
    for (int x = 0; x < shape.width; ++x, costs += shape.Stride()) {
      volume.costs.insert(volume.costs.end(), costs, costs + shape.disparities);
    }
  }
  return volume;
}

// The costs as Matcher computes them for the first pair of a rig.
CostVolume ComputeCosts(const LoadedPair& pair, const Options& options) {
  ThreadPool pool(options.threads);
  ImagePair images;
  images.Prepare(pair.left, pair.right);
  const AlignmentReport alignment =
      RigAlignment().Update(options.alignment, images.left_gray(), images.right_gray(),
                            options.min_disparity, options.num_disparities);
  if (alignment.applied) {
    cv::Mat warped;
    WarpRows(images.right_gray(), alignment.scale, alignment.offset, &warped, &pool);
    images.right_gray() = warped;
  }
  CoarsePass coarse;
  coarse.Run(options, images, &pool);
  const VolumeShape shape{images.size().width, images.size().height, options.num_disparities,
                          options.min_disparity};
  CostComputer computer;
  return Copied(computer.Prepare(options.cost, images.left_gray(), images.right_gray(), shape,
                                 coarse.FitRadiometry(options.cost.kind), 1, &pool));
}

void Run(const Arguments& a) {
  CheckWritable(a.output);
  CheckCostVolumeName(a.output);
  const LoadedPair pair = a.pair.Load();
  Options options = a.matcher.ToOptions();
  a.pair.SetRange(pair, std::nullopt, &options);
  CheckOptions(options);
  WriteCostVolume(a.output, ComputeCosts(pair, options));
}

}  // namespace
}  // namespace stereo_sgmp

int main(int argc, char** argv) {
  stereo_sgmp::Arguments arguments;
  CLI::App app(stereo_sgmp::kDescription, "make_cost_volume");
  stereo_sgmp::AddFlags(&app, &arguments);
  return stereo_sgmp::RunTool(argc, argv, &app, [&] { stereo_sgmp::Run(arguments); });
}
