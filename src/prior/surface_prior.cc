#include "prior/surface_prior.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <stdexcept>
#include <string>

namespace stereo_sgmp {
namespace {

// Far outside of any search range; keeps S^ apart from kUnknown.
constexpr float kLargest = 32000.0F;

}  // namespace

void SurfacePrior::Assign(const cv::Mat& surface, const VolumeShape& shape) {
  if (surface.type() != CV_32FC1 || surface.cols != shape.width || surface.rows != shape.height) {
    throw std::invalid_argument(
        "The prior surface is " + std::to_string(surface.cols) + "x" +
        std::to_string(surface.rows) + " of OpenCV type " + std::to_string(surface.type()) +
        "; expected CV_32F of the image's size, " + std::to_string(shape.width) + "x" +
        std::to_string(shape.height) + ".");
  }
  shape_ = shape;
  rounded_.create(surface.size());
  for (int y = 0; y < surface.rows; ++y) {
    const float* values = surface.ptr<float>(y);
    std::int16_t* rounded = rounded_[y];
    for (int x = 0; x < surface.cols; ++x) {
      const float value = std::clamp(std::floor(values[x] + 0.5F), -kLargest, kLargest);
      rounded[x] = std::isfinite(values[x]) ? static_cast<std::int16_t>(value) : kUnknown;
    }
  }
}

void SurfacePrior::Jumps(int y, int x_begin, int x_end, PathStep step, JumpRow* row) const {
  row->Reset(static_cast<std::size_t>(x_end - x_begin));
  row->MoveAll();
  const int y_p = y - step.dy;
  if (y_p < 0 || y_p >= shape_.height) return;
  const std::int16_t* at_p = rounded_[y_p];
  const std::int16_t* at_q = rounded_[y];
  const int inside_begin = std::max(x_begin, step.dx);
  const int inside_end = std::min(x_end, shape_.width + step.dx);
  for (int x = inside_begin; x < inside_end; ++x) {
    row->jump[static_cast<std::size_t>(x - x_begin)] = Jump(at_p[x - step.dx], at_q[x]);
  }
}

}  // namespace stereo_sgmp
