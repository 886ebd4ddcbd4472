#include "cost/cost_computer.h"

#include <sstream>
#include <stdexcept>

namespace stereo_sgmp {
namespace {

void CheckImage(const char* side, const cv::Mat& image, const VolumeShape& shape) {
  if (image.type() == CV_8UC1 && image.cols == shape.width && image.rows == shape.height) return;
  std::ostringstream message;
  message << "The " << side << " image for the matching cost is " << image.cols << "x" << image.rows
          << " of OpenCV type " << image.type() << ", expected " << shape.width << "x"
          << shape.height << " of type CV_8UC1; convert it to 8-bit gray of that size.";
  throw std::invalid_argument(message.str());
}

}  // namespace

const CostRows& CostComputer::Prepare(const CostOptions& options, const cv::Mat& left,
                                      const cv::Mat& right, const VolumeShape& shape,
                                      const RadiometricFit& fit, int unit, ThreadPool* pool) {
  const CostRows& costs = Start(options, left, right, shape, fit, unit, pool);
  Complete(pool);
  return costs;
}

const CostRows& CostComputer::Start(const CostOptions& options, const cv::Mat& left,
                                    const cv::Mat& right, const VolumeShape& shape,
                                    const RadiometricFit& fit, int unit, ThreadPool* pool) {
  CheckImage("left", left, shape);
  CheckImage("right", right, shape);
  is_stored_ = options.kind == CostKind::kNcc;
  switch (options.kind) {
    case CostKind::kNcc:
      ncc_.Start(left, right, shape, options.ncc_epsilon, options.vertical_tolerance, unit, pool);
      return ncc_;
    case CostKind::kCensus:
      census_.Prepare(left, right, shape, options.census_window, unit, pool);
      return census_;
    case CostKind::kMixed:
      mixed_.Prepare(left, right, shape, fit, unit, pool);
      return mixed_;
  }
  throw std::invalid_argument("The matching cost is none of CostKind; use one that it lists.");
}

void CostComputer::ComputeAhead(const std::function<bool()>& is_enough) {
  if (is_stored_) ncc_.ComputeAhead(is_enough);
}

void CostComputer::Complete(ThreadPool* pool) {
  if (is_stored_) ncc_.Complete(pool);
}

std::size_t CostMemory(const CostOptions& options, const VolumeShape& shape) {
  switch (options.kind) {
    case CostKind::kNcc:
      return NccCost::Memory(shape);
    case CostKind::kCensus:
      return CensusCost::Memory(shape, options.census_window);
    case CostKind::kMixed:
      return MixedCost::Memory(shape);
  }
  return 0;
}

}  // namespace stereo_sgmp
