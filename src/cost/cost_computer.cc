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
  const CostRows& costs = Start(options, left, right, shape, fit, unit);
  PrepareLeft(pool);
  PrepareRight(pool);
  Complete(pool);
  return costs;
}

const CostRows& CostComputer::Start(const CostOptions& options, const cv::Mat& left,
                                    const cv::Mat& right, const VolumeShape& shape,
                                    const RadiometricFit& fit, int unit) {
  CheckImage("left", left, shape);
  CheckImage("right", right, shape);
  kind_ = options.kind;
  left_ = left;
  right_ = right;
  switch (options.kind) {
    case CostKind::kNcc:
      ncc_.Start(shape, options.ncc_epsilon, options.vertical_tolerance, unit);
      return ncc_;
    case CostKind::kCensus:
      census_.Start(shape, options.census_window, unit);
      return census_;
    case CostKind::kMixed:
      mixed_.Start(shape, fit, unit);
      return mixed_;
  }
  throw std::invalid_argument("The matching cost is none of CostKind; use one that it lists.");
}

template <class Function>
void CostComputer::WithCosts(const Function& function) {
  switch (kind_) {
    case CostKind::kNcc:
      return function(&ncc_);
    case CostKind::kCensus:
      return function(&census_);
    case CostKind::kMixed:
      return function(&mixed_);
  }
}

void CostComputer::PrepareLeft(ThreadPool* pool) {
  WithCosts([&](auto* costs) { costs->PrepareLeft(left_, pool); });
}

void CostComputer::PrepareRight(ThreadPool* pool) {
  WithCosts([&](auto* costs) { costs->PrepareRight(right_, pool); });
}

void CostComputer::ComputeAhead(const std::function<bool()>& is_enough) {
  if (kind_ == CostKind::kNcc) ncc_.ComputeAhead(is_enough);
}

void CostComputer::Complete(ThreadPool* pool) {
  if (kind_ == CostKind::kNcc) ncc_.Complete(pool);
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
