#include "tools/pair_flags.h"

#include <algorithm>
#include <stdexcept>

#include "io/image.h"

namespace stereo_sgmp {

void PairFlags::AddTo(CLI::App* app) {
  app->add_option("left", left_, "Left image: 8 or 16 bit, gray or colour")->required();
  app->add_option("right", right_, "Right image, of the same size and type")->required();
  calib_flag_ = app->add_option(
      "--calib", calib_, "Middlebury calib.txt: the camera, and ndisp for --num-disparities");
  app->add_option_function<int>(
      "--min-disparity", [this](int value) { min_disparity_ = value; },
      "Smallest disparity searched, pixels; may be negative");
  app->add_option_function<int>(
      "--num-disparities", [this](int value) { num_disparities_ = value; },
      "Number of disparities searched. Without it that of a cost volume, of --calib, or of the "
      "preset, at most the width of the image");
}

LoadedPair PairFlags::Load() const {
  LoadedPair pair;
  pair.left = LoadImage(left_);
  pair.right = LoadImage(right_);
  CheckPair(pair.left, left_, pair.right, right_);
  if (calib_.empty()) return pair;
  pair.calibration = ReadCalibration(calib_);
  const cv::Size size = pair.calibration->size;
  if (!size.empty() && size != pair.left.size()) {
    throw std::invalid_argument(calib_ + ": it is for images of " + std::to_string(size.width) +
                                " x " + std::to_string(size.height) + " pixels, but " + left_ +
                                " has " + std::to_string(pair.left.cols) + " x " +
                                std::to_string(pair.left.rows) + ".");
  }
  return pair;
}

void PairFlags::SetRange(const LoadedPair& pair, const std::optional<CostVolume>& volume_shape,
                         Options* options) const {
  if (min_disparity_) {
    options->min_disparity = *min_disparity_;
  } else if (volume_shape) {
    options->min_disparity = volume_shape->min_disparity;
  }
  if (num_disparities_) {
    options->num_disparities = *num_disparities_;
  } else if (volume_shape) {
    options->num_disparities = volume_shape->disparities;
  } else if (pair.calibration && pair.calibration->num_disparities > 0) {
    options->num_disparities = pair.calibration->num_disparities;
  } else {
    options->num_disparities = std::min(options->num_disparities, pair.left.cols);
  }
}

}  // namespace stereo_sgmp
