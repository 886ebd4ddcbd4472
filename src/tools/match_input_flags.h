#ifndef STEREO_SGMP_TOOLS_MATCH_INPUT_FLAGS_H_
#define STEREO_SGMP_TOOLS_MATCH_INPUT_FLAGS_H_

#include <memory>
#include <optional>
#include <string>

#include <CLI/CLI.hpp>

#include "stereo_sgmp/match_inputs.h"
#include "stereo_sgmp/options.h"
#include "tools/pair_flags.h"

namespace stereo_sgmp {

struct LoadedInputs {
  MatchInputs inputs;
  std::unique_ptr<CostVolume> costs;  // what inputs.costs points to
};

// The flags for what is known of a pair beyond its images: --prior-surface, --prior-scale,
// --prior-depth, --normals and --discontinuities. Must outlive the parsing.
class MatchInputFlags {
 public:
  // `calib` is the flag that gives the camera.
  void AddTo(CLI::App* app, CLI::Option* calib);

  // Reads the files of the flags and, unless its name is empty, the cost volume, which has the
  // shape that stands beside it or else that of the pair and the options. Throws
  // std::invalid_argument for files that are malformed or not of the size of the pair.
  LoadedInputs Load(const LoadedPair& pair, const Options& options,
                    const std::string& cost_volume) const;

 private:
  cv::Mat LoadSurface(const LoadedPair& pair) const;
  cv::Mat LoadDiscontinuities(const LoadedPair& pair) const;

  std::string surface_;
  double scale_ = 0.0;
  bool surface_is_depth_ = false;
  std::string normals_;
  std::string discontinuities_;
};

}  // namespace stereo_sgmp

#endif  // STEREO_SGMP_TOOLS_MATCH_INPUT_FLAGS_H_
