#include "cost/census_cost.h"

#include "cost/census_cost_kernel.h"
#include "cost/cost_unit.h"

namespace stereo_sgmp {
namespace {

CensusShape ShapeOf(CensusWindow window) {
  return window == CensusWindow::k5x5 ? kCensus5x5 : kCensus9x7;
}

}  // namespace

void CensusCost::Start(const VolumeShape& shape, CensusWindow window, int unit) {
  CheckCostUnit(unit);
  shape_ = shape;
  unit_ = unit;
  window_ = window;
}

void CensusCost::PrepareLeft(const cv::Mat& left, ThreadPool* pool) {
  left_image_.Assign(left, Orientation::kNatural);
  Transform(left_image_, &left_, pool);
}

void CensusCost::PrepareRight(const cv::Mat& right, ThreadPool* pool) {
  right_image_.Assign(right, Orientation::kMirrored);
  Transform(right_image_, &right_, pool);
}

void CensusCost::Transform(const PaddedGray& image, FeaturePlanes* planes, ThreadPool* pool) const {
  const CensusShape census = ShapeOf(window_);
  planes->Create(census.Bytes(), shape_.width, shape_.height);
  pool->ForRanges(shape_.height, [&](int begin, int end) {
    for (int y = begin; y < end; ++y) CensusTransformRow(image, census, y, planes);
  });
}

const std::uint8_t* CensusCost::Row(int y, int x_begin, int x_end, std::uint8_t* scratch) const {
  const auto compute = window_ == CensusWindow::k5x5 ? Census5x5CostRow : Census9x7CostRow;
  compute(left_.Row(y), right_.Row(y), shape_, unit_, x_begin, x_end, scratch);
  return scratch;
}

std::size_t CensusCost::Memory(const VolumeShape& shape, CensusWindow window) {
  return 2 * (FeaturePlanes::Bytes(ShapeOf(window).Bytes(), shape.width, shape.height) +
              PaddedGray::Bytes(shape.width, shape.height));
}

}  // namespace stereo_sgmp
