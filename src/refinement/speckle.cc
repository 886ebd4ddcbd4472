#include "refinement/speckle.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>

#include "stereo_sgmp/match_result.h"

namespace stereo_sgmp {
namespace {

constexpr auto kValid = static_cast<std::uint8_t>(InvalidReason::kValid);
constexpr auto kSpeckle = static_cast<std::uint8_t>(InvalidReason::kSpeckle);

}  // namespace

void SpeckleFilter::Mark(const cv::Mat& disparity, int size, double range, cv::Mat* reason,
                         ThreadPool* pool) {
  if (size <= 1) return;
  const float max_step = static_cast<float>(range);
  // None without rows, which would part its neighbours.
  const int bands = std::min(pool->size(), disparity.rows);
  bands_.resize(static_cast<std::size_t>(bands));
  pool->ForPieces(bands, 1, [&](int, int band, int) {
    const int begin = static_cast<int>(std::int64_t{disparity.rows} * band / bands);
    const int end = static_cast<int>(std::int64_t{disparity.rows} * (band + 1) / bands);
    bands_[static_cast<std::size_t>(band)].Find(disparity, *reason, max_step, begin, end);
  });
  Gather(disparity, max_step, pool);
  pool->ForRanges(all_.Count(), [&](int begin, int end) {
    for (int i = begin; i < end; ++i) {
      const Run& run = all_.runs[static_cast<std::size_t>(i)];
      if (all_.areas[static_cast<std::size_t>(all_.FindRoot(i))] >= size) continue;
      std::uint8_t* row = reason->ptr<std::uint8_t>(run.y);
      std::fill(row + run.begin, row + run.end, kSpeckle);
    }
  });
}

void SpeckleFilter::Gather(const cv::Mat& disparity, float range, ThreadPool* pool) {
  offsets_.clear();
  std::int32_t count = 0;
  for (const Regions& band : bands_) {
    offsets_.push_back(count);
    count += band.Count();
  }
  all_.runs.resize(static_cast<std::size_t>(count));
  all_.parents.resize(static_cast<std::size_t>(count));
  all_.areas.resize(static_cast<std::size_t>(count));
  pool->ForPieces(static_cast<int>(bands_.size()), 1, [&](int, int piece, int) {
    const auto band = static_cast<std::size_t>(piece);
    CopyBand(band, offsets_[band]);
  });
  for (std::size_t i = 1; i < bands_.size(); ++i) {
    const std::int32_t above = offsets_[i - 1];
    const std::int32_t below = offsets_[i];
    all_.JoinRows(disparity, range, above + bands_[i - 1].last_row_begin, below, below,
                  below + bands_[i].first_row_end);
  }
}

void SpeckleFilter::CopyBand(std::size_t band, std::int32_t offset) {
  const Regions& from = bands_[band];
  std::copy(from.runs.begin(), from.runs.end(), all_.runs.begin() + offset);
  std::copy(from.areas.begin(), from.areas.end(), all_.areas.begin() + offset);
  std::transform(from.parents.begin(), from.parents.end(), all_.parents.begin() + offset,
                 [offset](std::int32_t parent) { return parent + offset; });
}

void SpeckleFilter::Regions::Find(const cv::Mat& disparity, const cv::Mat& reason, float range,
                                  int y_begin, int y_end) {
  runs.clear();
  parents.clear();
  areas.clear();
  first_row_end = 0;
  last_row_begin = 0;
  for (int y = y_begin; y < y_end; ++y) {
    const std::int32_t row = Count();
    FindRuns(disparity, reason, range, y);
    if (y == y_begin) first_row_end = Count();
    JoinRows(disparity, range, last_row_begin, row, row, Count());
    last_row_begin = row;
  }
}

void SpeckleFilter::Regions::FindRuns(const cv::Mat& disparity, const cv::Mat& reason, float range,
                                      int y) {
  const float* d = disparity.ptr<float>(y);
  const std::uint8_t* state = reason.ptr<std::uint8_t>(y);
  for (int x = 0; x < disparity.cols;) {
    if (state[x] != kValid) {
      ++x;
      continue;
    }
    const int begin = x++;
    while (x < disparity.cols && state[x] == kValid && std::abs(d[x] - d[x - 1]) <= range) ++x;
    parents.push_back(static_cast<std::int32_t>(runs.size()));
    areas.push_back(x - begin);
    runs.push_back({y, begin, x});
  }
}

// Walks along the runs of both rows at once.
void SpeckleFilter::Regions::JoinRows(const cv::Mat& disparity, float range, std::int32_t above,
                                      std::int32_t above_end, std::int32_t row,
                                      std::int32_t row_end) {
  while (above < above_end && row < row_end) {
    const Run& upper = runs[static_cast<std::size_t>(above)];
    const Run& lower = runs[static_cast<std::size_t>(row)];
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

void SpeckleFilter::Regions::Join(std::int32_t run, std::int32_t other) {
  const std::int32_t a = RootOf(run);
  const std::int32_t b = RootOf(other);
  if (a == b) return;
  // The earlier run stays the root, so that paths stay short as rows are added.
  const auto root = static_cast<std::size_t>(std::min(a, b));
  const auto child = static_cast<std::size_t>(std::max(a, b));
  parents[child] = static_cast<std::int32_t>(root);
  areas[root] += areas[child];
}

std::int32_t SpeckleFilter::Regions::RootOf(std::int32_t run) {
  auto i = static_cast<std::size_t>(run);
  while (parents[i] != static_cast<std::int32_t>(i)) {
    const auto parent = static_cast<std::size_t>(parents[i]);
    parents[i] = parents[parent];
    i = static_cast<std::size_t>(parents[i]);
  }
  return static_cast<std::int32_t>(i);
}

std::int32_t SpeckleFilter::Regions::FindRoot(std::int32_t run) const {
  std::int32_t parent = parents[static_cast<std::size_t>(run)];
  for (; parent != run; parent = parents[static_cast<std::size_t>(run)]) run = parent;
  return run;
}

}  // namespace stereo_sgmp
