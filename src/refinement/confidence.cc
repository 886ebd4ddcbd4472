#include "refinement/confidence.h"

#include <cstdint>

#include "refinement/confidence_kernel.h"

namespace stereo_sgmp {
namespace {

// What S and with it U_p is the sum of, each worth some P1.
int PathEvaluations(PathScheme scheme) { return scheme == PathScheme::kFour ? 4 : 8; }

void UncertaintyRow(const WinnerMap& map, int y, float scale, float* row) {
  const std::uint16_t* uncertainty = map.uncertainty[y];
  for (int x = 0; x < map.winner.cols; ++x) {
    row[x] = 1.0f / (1.0f + static_cast<float>(uncertainty[x]) / scale);
  }
}

}  // namespace

void ComputeConfidence(const WinnerMap& map, const cv::Mat& left_right, ConfidenceMeasure measure,
                       const AggregationOptions& aggregation, int begin, int end,
                       cv::Mat* confidence) {
  const int paths = PathEvaluations(aggregation.scheme);
  const float scale = static_cast<float>(paths * aggregation.p1);
  const float weight = 8.0f / static_cast<float>(paths);
  for (int y = begin; y < end; ++y) {
    float* row = confidence->ptr<float>(y);
    if (measure == ConfidenceMeasure::kPeakDifference) {
      PeakDifferenceRow(map, left_right.ptr<std::uint16_t>(y), y, weight, row);
    } else {
      UncertaintyRow(map, y, scale, row);
    }
  }
}

void UncertaintyImage(const WinnerMap& map, int begin, int end, cv::Mat* uncertainty) {
  cv::Mat rows = uncertainty->rowRange(begin, end);
  map.uncertainty.rowRange(begin, end).convertTo(rows, CV_32F);
}

}  // namespace stereo_sgmp
