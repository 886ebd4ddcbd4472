#include "cost/census_cost.h"

#include "cost/census_cost_kernel.h"
#include "cost/cost_unit.h"

namespace stereo_sgmp {
namespace {

CensusShape ShapeOf(CensusWindow window) {
  return window == CensusWindow::k5x5 ? kCensus5x5 : kCensus9x7;
}

}  // namespace

void CensusCost::Prepare(const cv::Mat& left, const cv::Mat& right, const VolumeShape& shape,
                         CensusWindow window, int unit, ThreadPool* pool) {
  CheckCostUnit(unit);
  shape_ = shape;
  unit_ = unit;
  window_ = window;
  const CensusShape census = ShapeOf(window);
  left_image_.Assign(left, Orientation::kNatural);
  right_image_.Assign(right, Orientation::kMirrored);
  left_.Create(census.Bytes(), shape.width, shape.height);
  right_.Create(census.Bytes(), shape.width, shape.height);
  pool->ForRanges(shape.height, [&](int begin, int end) {
    for (int y = begin; y < end; ++y) {
      CensusTransformRow(left_image_, census, y, &left_);
      CensusTransformRow(right_image_, census, y, &right_);
    }
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
