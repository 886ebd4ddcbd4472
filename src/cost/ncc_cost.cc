#include "cost/ncc_cost.h"

#include <algorithm>

#include "cost/compact_kernel.h"
#include "cost/cost_unit.h"
#include "cost/ncc_cost_kernel.h"

namespace stereo_sgmp {
namespace {

// Two flat patches have NCC 0 for any epsilon above 0; this keeps 0 / 0 out for epsilon = 0.
constexpr float kSmallestEpsilon = 1e-6F;

}  // namespace

void NccCost::Start(const VolumeShape& shape, double epsilon, bool vertical_tolerance, int unit) {
  CheckCostUnit(unit);
  unit_ = unit;
  const float used_epsilon = std::max(static_cast<float>(epsilon), kSmallestEpsilon);
  const int tolerance = vertical_tolerance ? 1 : 0;
  volume_.Start(shape, [=](int y, std::uint8_t* costs) {
    NccRows rows;
    rows.left = &left_;
    rows.right = &right_;
    rows.left_y = y;
    rows.right_first = std::max(y - tolerance, 0);
    rows.right_count = std::min(y + tolerance, shape.height - 1) - rows.right_first + 1;
    NccCostRow(rows, shape, used_epsilon, costs);
    const int padded = shape.width * shape.Stride();
    CompactCosts(unit, static_cast<std::size_t>(padded), costs);
  });
}

void NccCost::PrepareLeft(const cv::Mat& left, ThreadPool* pool) {
  left_image_.Assign(left, Orientation::kNatural);
  left_.Compute(left_image_, pool);
}

void NccCost::PrepareRight(const cv::Mat& right, ThreadPool* pool) {
  right_image_.Assign(right, Orientation::kMirrored);
  right_.Compute(right_image_, pool);
}

std::size_t NccCost::Memory(const VolumeShape& shape) {
  return shape.PaddedSize() + 2 * (PatchStatistics::Bytes(shape.width, shape.height) +
                                   PaddedGray::Bytes(shape.width, shape.height));
}

}  // namespace stereo_sgmp
