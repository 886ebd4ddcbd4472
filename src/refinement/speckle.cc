#include "refinement/speckle.h"

#include <algorithm>
#include <cmath>
#include <cstddef>

#include "stereo_sgmp/match_result.h"

namespace stereo_sgmp {
namespace {

constexpr auto kValid = static_cast<std::uint8_t>(InvalidReason::kValid);
constexpr auto kSpeckle = static_cast<std::uint8_t>(InvalidReason::kSpeckle);

}  // namespace

void SpeckleFilter::Mark(const cv::Mat& disparity, int size, double range, cv::Mat* reason) {
  if (size <= 1) return;
  const float max_step = static_cast<float>(range);
  runs_.clear();
  parents_.clear();
  areas_.clear();
  std::size_t above = 0;
  for (int y = 0; y < disparity.rows; ++y) {
    const std::size_t row = runs_.size();
    FindRuns(disparity, *reason, max_step, y);
    JoinRows(disparity, max_step, static_cast<std::int32_t>(above), static_cast<std::int32_t>(row));
    above = row;
  }
  for (std::size_t i = 0; i < runs_.size(); ++i) {
    const Run& run = runs_[i];
    if (areas_[static_cast<std::size_t>(RootOf(static_cast<std::int32_t>(i)))] >= size) continue;
    std::uint8_t* row = reason->ptr<std::uint8_t>(run.y);
    std::fill(row + run.begin, row + run.end, kSpeckle);
  }
}

void SpeckleFilter::FindRuns(const cv::Mat& disparity, const cv::Mat& reason, float range, int y) {
  const float* d = disparity.ptr<float>(y);
  const std::uint8_t* state = reason.ptr<std::uint8_t>(y);
  for (int x = 0; x < disparity.cols;) {
    if (state[x] != kValid) {
      ++x;
      continue;
    }
    const int begin = x++;
    while (x < disparity.cols && state[x] == kValid && std::abs(d[x] - d[x - 1]) <= range) ++x;
    parents_.push_back(static_cast<std::int32_t>(runs_.size()));
    areas_.push_back(x - begin);
    runs_.push_back({y, begin, x});
  }
}

// Walks along the runs of two rows, [above, row) and [row, end), at once and joins those that
// touch at a small step.
void SpeckleFilter::JoinRows(const cv::Mat& disparity, float range, std::int32_t above,
                             std::int32_t row) {
  const std::int32_t above_end = row;
  const std::int32_t row_end = static_cast<std::int32_t>(runs_.size());
  while (above < above_end && row < row_end) {
    const Run& upper = runs_[static_cast<std::size_t>(above)];
    const Run& lower = runs_[static_cast<std::size_t>(row)];
    const float* d_upper = disparity.ptr<float>(upper.y);
    const float* d_lower = disparity.ptr<float>(lower.y);
    const int end = std::min(upper.end, lower.end);
    int x = std::max(upper.begin, lower.begin);
    while (x < end && !(std::abs(d_upper[x] - d_lower[x]) <= range)) ++x;
    if (x < end) Join(row, above);
    if (upper.end <= lower.end) {
      ++above;
    } else {
      ++row;
    }
  }
}

void SpeckleFilter::Join(std::int32_t run, std::int32_t other) {
  const std::int32_t a = RootOf(run);
  const std::int32_t b = RootOf(other);
  if (a == b) return;
  // The earlier run stays the root, so that paths stay short as rows are added.
  const auto root = static_cast<std::size_t>(std::min(a, b));
  const auto child = static_cast<std::size_t>(std::max(a, b));
  parents_[child] = static_cast<std::int32_t>(root);
  areas_[root] += areas_[child];
}

std::int32_t SpeckleFilter::RootOf(std::int32_t run) {
  auto i = static_cast<std::size_t>(run);
  while (parents_[i] != static_cast<std::int32_t>(i)) {
    const auto parent = static_cast<std::size_t>(parents_[i]);
    parents_[i] = parents_[parent];
    i = static_cast<std::size_t>(parents_[i]);
  }
  return static_cast<std::int32_t>(i);
}

}  // namespace stereo_sgmp
