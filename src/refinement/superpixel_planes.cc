#include "refinement/superpixel_planes.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>

#include "prior/plane_fit.h"

namespace stereo_sgmp {
namespace {

constexpr int kMinPixels = 30;  // of those that are sampled
constexpr int kTrials = 30;
constexpr float kInlierDistance = 0.7f;  // pixels of disparity
constexpr double kMinSupport = 0.5;      // inliers among the valid pixels of a superpixel
constexpr double kMinTwiceArea = 10.0;   // of a sample's triangle, px^2: thinner ones mislead
constexpr std::uint8_t kNowValid = 255;
constexpr std::uint64_t kSeed = 0x9E3779B97F4A7C15u;  // odd: labels give seeds far apart

// The valid pixels of one superpixel.
struct PixelGroup {
  const float* x;
  const float* y;
  const float* d;
  int count;
};

float Distance(const DisparityPlane& plane, const PixelGroup& group, int i) {
  const float value = static_cast<float>(plane.a) * group.x[i] +
                      static_cast<float>(plane.b) * group.y[i] + static_cast<float>(plane.c);
  return std::abs(value - group.d[i]);
}

int CountInliers(const DisparityPlane& plane, const PixelGroup& group) {
  int inliers = 0;
  for (int i = 0; i < group.count; ++i) {
    inliers += Distance(plane, group, i) < kInlierDistance ? 1 : 0;
  }
  return inliers;
}

// The plane through three pixels; none if they are nearly in a line.
std::optional<DisparityPlane> PlaneThrough(const PixelGroup& group, int i, int j, int k) {
  const double xj = group.x[j] - group.x[i];
  const double yj = group.y[j] - group.y[i];
  const double dj = group.d[j] - group.d[i];
  const double xk = group.x[k] - group.x[i];
  const double yk = group.y[k] - group.y[i];
  const double dk = group.d[k] - group.d[i];
  const double determinant = xj * yk - xk * yj;
  if (std::abs(determinant) < kMinTwiceArea) return std::nullopt;
  const double a = (dj * yk - dk * yj) / determinant;
  const double b = (dk * xj - dj * xk) / determinant;
  return DisparityPlane{a, b, group.d[i] - a * group.x[i] - b * group.y[i]};
}

DisparityPlane FitInliers(const DisparityPlane& plane, const PixelGroup& group) {
  PlaneMoments moments;
  for (int i = 0; i < group.count; ++i) {
    if (Distance(plane, group, i) < kInlierDistance) {
      moments.Add(group.x[i], group.y[i], group.d[i]);
    }
  }
  return moments.Fit();
}

std::optional<DisparityPlane> RobustPlane(const PixelGroup& group, cv::RNG random) {
  if (group.count < kMinPixels) return std::nullopt;
  int most_inliers = 0;
  DisparityPlane best;
  for (int trial = 0; trial < kTrials; ++trial) {
    const int i = random.uniform(0, group.count);
    const int j = random.uniform(0, group.count);
    const int k = random.uniform(0, group.count);
    const std::optional<DisparityPlane> plane = PlaneThrough(group, i, j, k);
    if (!plane) continue;
    const int inliers = CountInliers(*plane, group);
    if (inliers > most_inliers) {
      most_inliers = inliers;
      best = *plane;
    }
  }
  if (most_inliers == 0 || most_inliers < kMinSupport * group.count) return std::nullopt;
  return FitInliers(best, group);
}

}  // namespace

void SuperpixelPlanes::Apply(const cv::Mat& labels, int count, const VolumeShape& shape,
                             cv::Mat* disparity, cv::Mat* valid, ThreadPool* pool) {
  GroupValidPixels(labels, count, *disparity, *valid);
  planes_.resize(static_cast<std::size_t>(count));
  pool->ForRanges(count, [&](int begin, int end) {
    for (int k = begin; k < end; ++k) planes_[static_cast<std::size_t>(k)] = FitPlane(k);
  });
  pool->ForRanges(disparity->rows, [&](int begin, int end) {
    for (int y = begin; y < end; ++y) {
      FillRow(labels.ptr<std::int32_t>(y / kLabelScale), shape, y, disparity->ptr<float>(y),
              valid->ptr<std::uint8_t>(y));
    }
  });
}

void SuperpixelPlanes::FillRow(const std::int32_t* labels, const VolumeShape& shape, int y,
                               float* disparity, std::uint8_t* valid) const {
  const double lowest = shape.min_disparity;
  const double highest = shape.min_disparity + shape.disparities - 1;
  for (int x = 0; x < shape.width; ++x) {
    if (valid[x] != 0) continue;
    const std::optional<DisparityPlane>& plane =
        planes_[static_cast<std::size_t>(labels[x / kLabelScale])];
    if (!plane) continue;
    const double value = plane->At(x, y);
    if (!(value >= lowest && value <= highest)) continue;
    disparity[x] = static_cast<float>(value);
    valid[x] = kNowValid;
  }
}

// A counting sort by label: pixels of one superpixel stay in the order of rows.
void SuperpixelPlanes::GroupValidPixels(const cv::Mat& labels, int count, const cv::Mat& disparity,
                                        const cv::Mat& valid) {
  const auto for_valid_pixels = [&](auto&& visit) {
    for (int y = 0; y < valid.rows; y += kLabelScale) {
      const auto* label = labels.ptr<std::int32_t>(y / kLabelScale);
      const auto* is_valid = valid.ptr<std::uint8_t>(y);
      for (int x = 0; x < valid.cols; x += kLabelScale) {
        if (is_valid[x] != 0) visit(static_cast<std::size_t>(label[x / kLabelScale]), x, y);
      }
    }
  };
  first_.assign(static_cast<std::size_t>(count) + 1, 0);
  for_valid_pixels([&](std::size_t k, int, int) { ++first_[k + 1]; });
  for (std::size_t k = 1; k < first_.size(); ++k) first_[k] += first_[k - 1];
  next_.assign(first_.begin(), first_.end());
  for (auto* values : {&x_, &y_, &d_}) values->resize(static_cast<std::size_t>(first_.back()));
  for_valid_pixels([&](std::size_t k, int x, int y) {
    const auto i = static_cast<std::size_t>(next_[k]++);
    x_[i] = static_cast<float>(x);
    y_[i] = static_cast<float>(y);
    d_[i] = disparity.at<float>(y, x);
  });
}

// Each superpixel has random numbers of its own, so that all can be fitted at the same time.
std::optional<DisparityPlane> SuperpixelPlanes::FitPlane(int label) const {
  const int first = first_[static_cast<std::size_t>(label)];
  const int count = first_[static_cast<std::size_t>(label) + 1] - first;
  const PixelGroup group = {x_.data() + first, y_.data() + first, d_.data() + first, count};
  return RobustPlane(group, cv::RNG(kSeed * (static_cast<std::uint64_t>(label) + 1)));
}

}  // namespace stereo_sgmp
