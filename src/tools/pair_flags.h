#ifndef STEREO_SGMP_TOOLS_PAIR_FLAGS_H_
#define STEREO_SGMP_TOOLS_PAIR_FLAGS_H_

#include <optional>
#include <string>

#include <CLI/CLI.hpp>
#include <opencv2/core.hpp>

#include "io/calib.h"
#include "stereo_sgmp/cost_volume.h"
#include "stereo_sgmp/options.h"

namespace stereo_sgmp {

struct LoadedPair {
  cv::Mat left;
  cv::Mat right;
  std::optional<Calibration> calibration;
};

// The flags of tools that work on one stereo pair: its images, --calib, --min-disparity and
// --num-disparities. Must outlive the parsing.
class PairFlags {
 public:
  void AddTo(CLI::App* app);

  // For flags that need --calib.
  CLI::Option* calib_flag() const { return calib_flag_; }

  // Throws std::invalid_argument for files that are malformed or do not fit together.
  LoadedPair Load() const;

  // Sets the range of disparities: that of the flags, else of the cost volume, where its shape is
  // known, else of the calibration, else of `options`, then at most the width of the image.
  void SetRange(const LoadedPair& pair, const std::optional<CostVolume>& volume_shape,
                Options* options) const;

 private:
  std::string left_;
  std::string right_;
  std::string calib_;
  CLI::Option* calib_flag_ = nullptr;
  std::optional<int> min_disparity_;
  std::optional<int> num_disparities_;
};

}  // namespace stereo_sgmp

#endif  // STEREO_SGMP_TOOLS_PAIR_FLAGS_H_
