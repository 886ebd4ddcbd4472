#include "cost/mixed_cost.h"

#include <algorithm>
#include <array>
#include <sstream>
#include <stdexcept>

#include "cost/census_transform.h"
#include "cost/mixed_cost_kernel.h"

namespace stereo_sgmp {
namespace {

constexpr double kAdLimit = 30.0;

using GrayTable = std::array<std::uint8_t, 256>;

// gray -> weight (gain gray + offset) - 128 as a signed byte. With both images weighted, their
// differences are too.
GrayTable WeightedGrays(double gain, double offset, double weight) {
  GrayTable table;
  for (std::size_t gray = 0; gray < table.size(); ++gray) {
    const double mapped = std::clamp(gain * static_cast<double>(gray) + offset, 0.0, 255.0);
    table[gray] = cv::saturate_cast<std::uint8_t>(weight * mapped) ^ 0x80;
  }
  return table;
}

void GrayFeatures(const PaddedGray& image, const GrayTable& table, int y, FeaturePlanes* planes) {
  const std::uint8_t* row = image.Row(y);
  std::uint8_t* gray = planes->Plane(MixedFeatures::kGray, y);
  for (int x = 0; x < image.width(); ++x) gray[x] = table[row[x]];
}

void GradientFeatures(const PaddedGray& image, int y, FeaturePlanes* planes) {
  // Towards larger x of the scene, whichever way the row runs.
  const int step = image.orientation() == Orientation::kMirrored ? -1 : 1;
  const std::uint8_t* row = image.Row(y);
  SaturatedDifferences(row + step, row - step, image.width(),
                       planes->Plane(MixedFeatures::kGradientX, y));
  SaturatedDifferences(image.Row(y + 1), image.Row(y - 1), image.width(),
                       planes->Plane(MixedFeatures::kGradientY, y));
}

void Features(const PaddedGray& image, const GrayTable& table, FeaturePlanes* planes,
              ThreadPool* pool) {
  planes->Create(MixedFeatures::kPlanes, image.width(), image.height());
  pool->ForRanges(image.height(), [&](int begin, int end) {
    for (int y = begin; y < end; ++y) {
      CensusTransformRow(image, MixedFeatures::kCensus, y, planes);
      GrayFeatures(image, table, y, planes);
      GradientFeatures(image, y, planes);
    }
  });
}

void CheckUnit(int unit) {
  if (unit == 1 || unit == MixedCost::kCompactUnit) return;
  std::ostringstream message;
  message << "The unit of the mixed cost is " << unit << ", expected 1 (full costs) or "
          << MixedCost::kCompactUnit << " (compact costs); use one of these.";
  throw std::invalid_argument(message.str());
}

}  // namespace

void MixedCost::Start(const VolumeShape& shape, const RadiometricFit& fit, int unit) {
  CheckUnit(unit);
  shape_ = shape;
  unit_ = unit;
  fit_ = fit;
  ad_limit_ = cv::saturate_cast<std::uint8_t>(kAdLimit * fit.ad_weight);
}

void MixedCost::PrepareLeft(const cv::Mat& left, ThreadPool* pool) {
  left_image_.Assign(left, Orientation::kNatural);
  Features(left_image_, WeightedGrays(1.0, 0.0, fit_.ad_weight), &left_, pool);
}

void MixedCost::PrepareRight(const cv::Mat& right, ThreadPool* pool) {
  right_image_.Assign(right, Orientation::kMirrored);
  Features(right_image_, WeightedGrays(fit_.gain, fit_.offset, fit_.ad_weight), &right_, pool);
}

const std::uint8_t* MixedCost::Row(int y, int x_begin, int x_end, std::uint8_t* scratch) const {
  const auto compute = unit_ == kCompactUnit ? CompactMixedCostRow : FullMixedCostRow;
  compute(left_.Row(y), right_.Row(y), shape_, ad_limit_, x_begin, x_end, scratch);
  return scratch;
}

std::size_t MixedCost::Memory(const VolumeShape& shape) {
  return 2 * (FeaturePlanes::Bytes(MixedFeatures::kPlanes, shape.width, shape.height) +
              PaddedGray::Bytes(shape.width, shape.height));
}

}  // namespace stereo_sgmp
