#include "refinement/confidence.h"

#include <algorithm>
#include <cmath>
#include <cstdint>

#include "refinement/left_right.h"

namespace stereo_sgmp {
namespace {

constexpr int kRadius = 2;  // of the window that peak differences are averaged over
constexpr int kMaxLeftRight = 10;
constexpr float kLeftRightWeight = 100.0f;  // cost units for an index of difference

// Calibration on real pairs (mixed cost, P1 = 120, eight directions), in cost units: the measure
// at which half of the pixels are right, and the scale on which their share rises from there.
constexpr float kEvenMeasure = 420.0f;
constexpr float kMeasureScale = 430.0f;

constexpr int kPaths = 8;  // U_p is a sum over eight paths, each worth some P1

// Rises from 0 to 1 with 1/2 at 0. Approaches its ends slowly enough that large values, which a
// logistic function would round to 1, stay in order.
float ToUnitInterval(float t) {
  const float size = std::abs(t);
  return 0.5f + 0.5f * t * (1.0f + size) / (1.0f + size * (1.0f + size));
}

// sums[x] = peak differences of column x over the rows of the window around row y. All sums here
// are integers below 2^24, hence exact.
void SumColumns(const WinnerMap& map, int y, float* sums) {
  const int y_end = std::min(y + kRadius + 1, map.winner.rows);
  std::fill(sums, sums + map.winner.cols, 0.0f);
  for (int v = std::max(y - kRadius, 0); v < y_end; ++v) {
    const std::uint16_t* cost = map.cost[v];
    const std::uint16_t* second = map.second[v];
    for (int x = 0; x < map.winner.cols; ++x) {
      sums[x] += second[x] == WinnerMap::kNone ? 0.0f : static_cast<float>(second[x] - cost[x]);
    }
  }
}

// Number of pixels of a window of kRadius around `center` within [0, size).
int WindowLength(int center, int size) {
  return std::min(center + kRadius, size - 1) - std::max(center - kRadius, 0) + 1;
}

// From column sums over `rows` rows to means over the window. In place: the sums to the right of
// x are not yet overwritten, and those to the left are carried along.
void AverageColumns(int rows, int width, float* row) {
  float left2 = 0.0f;
  float left1 = 0.0f;
  for (int x = 0; x < width; ++x) {
    const float center = row[x];
    const float right1 = x + 1 < width ? row[x + 1] : 0.0f;
    const float right2 = x + 2 < width ? row[x + 2] : 0.0f;
    const float sum = left2 + left1 + center + right1 + right2;
    row[x] = sum / static_cast<float>(rows * WindowLength(x, width));
    left2 = left1;
    left1 = center;
  }
}

void PeakDifferenceRow(const WinnerMap& map, int y, float* row) {
  const int width = map.winner.cols;
  SumColumns(map, y, row);
  AverageColumns(WindowLength(y, map.winner.rows), width, row);
  const LeftRightRow left_right(map, y);
  for (int x = 0; x < width; ++x) {
    row[x] -= kLeftRightWeight * static_cast<float>(left_right.Difference(x, kMaxLeftRight));
  }
  for (int x = 0; x < width; ++x) row[x] = ToUnitInterval((row[x] - kEvenMeasure) / kMeasureScale);
}

void UncertaintyRow(const WinnerMap& map, int y, float scale, float* row) {
  const std::uint16_t* uncertainty = map.uncertainty[y];
  for (int x = 0; x < map.winner.cols; ++x) {
    row[x] = 1.0f / (1.0f + static_cast<float>(uncertainty[x]) / scale);
  }
}

}  // namespace

void ComputeConfidence(const WinnerMap& map, ConfidenceMeasure measure, int p1, cv::Mat* confidence,
                       ThreadPool* pool) {
  confidence->create(map.winner.size(), CV_32F);
  const float scale = static_cast<float>(kPaths * p1);
  pool->ForRanges(confidence->rows, [&](int begin, int end) {
    for (int y = begin; y < end; ++y) {
      float* row = confidence->ptr<float>(y);
      if (measure == ConfidenceMeasure::kPeakDifference) {
        PeakDifferenceRow(map, y, row);
      } else {
        UncertaintyRow(map, y, scale, row);
      }
    }
  });
}

void UncertaintyImage(const WinnerMap& map, cv::Mat* uncertainty) {
  map.uncertainty.convertTo(*uncertainty, CV_32F);
}

}  // namespace stereo_sgmp
