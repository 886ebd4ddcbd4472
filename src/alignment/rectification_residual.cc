#include "alignment/rectification_residual.h"

#include <algorithm>
#include <bitset>
#include <cmath>
#include <cstddef>

namespace stereo_sgmp {
namespace {

constexpr int kMaxCorners = 600;
constexpr int kSamples = 1000;
constexpr double kInlierDistance = 0.4;  // pixels
constexpr double kMinBaseShare = 0.2;    // of the rows between the two points of a sample
constexpr int kRefits = 3;
constexpr int kBands = 8;
constexpr std::size_t kMinBands = 4;
constexpr int kMinInliers = 30;
constexpr double kMinInlierShare = 0.5;
// Rows of wrong matches scatter evenly, which puts the median of those that happen to be inliers
// at half their largest distance; right ones lie within a tenth of a pixel.
constexpr double kMaxResidual = 0.12;
constexpr double kMaxScaleChange = 0.02;

struct Line {
  double a = 1.0;
  double b = 0.0;

  double Distance(const RowMatch& match) const {
    return std::abs(match.right - (a * match.left + b));
  }
};

std::vector<RowMatch> Inliers(const std::vector<RowMatch>& matches, const Line& line) {
  std::vector<RowMatch> inliers;
  for (const RowMatch& match : matches) {
    if (line.Distance(match) < kInlierDistance) inliers.push_back(match);
  }
  return inliers;
}

// The line through two matches that most matches agree with.
Line BestSample(const std::vector<RowMatch>& matches, int height) {
  cv::RNG rng(1);  // a fixed seed: the same matches give the same line
  const int count = static_cast<int>(matches.size());
  Line best;
  std::ptrdiff_t best_inliers = 0;
  for (int i = 0; i < kSamples; ++i) {
    const RowMatch& first = matches[static_cast<std::size_t>(rng.uniform(0, count))];
    const RowMatch& second = matches[static_cast<std::size_t>(rng.uniform(0, count))];
    const double base = second.left - first.left;
    if (std::abs(base) < kMinBaseShare * height) continue;
    const double a = (second.right - first.right) / base;
    const Line line{a, first.right - a * first.left};
    const auto inliers = std::count_if(matches.begin(), matches.end(), [&](const RowMatch& match) {
      return line.Distance(match) < kInlierDistance;
    });
    if (inliers > best_inliers) {
      best = line;
      best_inliers = inliers;
    }
  }
  return best;
}

Line LeastSquares(const std::vector<RowMatch>& matches, const Line& fallback) {
  const double n = static_cast<double>(matches.size());
  double mean_left = 0.0, mean_right = 0.0;
  for (const RowMatch& match : matches) {
    mean_left += match.left / n;
    mean_right += match.right / n;
  }
  double variance = 0.0, covariance = 0.0;
  for (const RowMatch& match : matches) {
    variance += (match.left - mean_left) * (match.left - mean_left);
    covariance += (match.left - mean_left) * (match.right - mean_right);
  }
  if (!(variance > 1.0)) return fallback;
  const double a = covariance / variance;
  return {a, mean_right - a * mean_left};
}

template <class Function>
double Median(const std::vector<RowMatch>& matches, const Function& value) {
  std::vector<double> values;
  values.reserve(matches.size());
  for (const RowMatch& match : matches) values.push_back(value(match));
  const auto middle = values.begin() + static_cast<std::ptrdiff_t>(values.size() / 2);
  std::nth_element(values.begin(), middle, values.end());
  return *middle;
}

bool IsReliable(const Line& line, const std::vector<RowMatch>& inliers, std::size_t matches,
                double residual, int height) {
  std::bitset<kBands> bands;
  for (const RowMatch& match : inliers) {
    bands.set(static_cast<std::size_t>(match.left * kBands / height));
  }
  return inliers.size() >= kMinInliers && bands.count() >= kMinBands && residual <= kMaxResidual &&
         static_cast<double>(inliers.size()) >= kMinInlierShare * static_cast<double>(matches) &&
         std::abs(line.a - 1.0) <= kMaxScaleChange;
}

}  // namespace

ResidualFit FitRows(const std::vector<RowMatch>& matches, int height) {
  ResidualFit fit;
  if (matches.empty()) return fit;
  fit.median_offset =
      Median(matches, [](const RowMatch& match) { return std::abs(match.right - match.left); });
  Line line = BestSample(matches, height);
  std::vector<RowMatch> inliers = Inliers(matches, line);
  for (int i = 0; i < kRefits; ++i) {
    line = LeastSquares(inliers, line);
    inliers = Inliers(matches, line);
  }
  fit.inliers = static_cast<int>(inliers.size());
  if (inliers.empty()) return fit;
  const double residual =
      Median(inliers, [&](const RowMatch& match) { return line.Distance(match); });
  if (!IsReliable(line, inliers, matches.size(), residual, height)) return fit;
  fit.reliable = true;
  fit.a = line.a;
  fit.b = line.b;
  fit.residual = residual;
  const double last = height - 1;
  fit.max_shift = std::max(std::abs(line.b), std::abs(line.a * last + line.b - last));
  return fit;
}

ResidualFit FitRectificationResidual(const cv::Mat& left, const cv::Mat& right, int min_disparity,
                                     int num_disparities) {
  return FitRows(FindRowMatches(left, right, min_disparity, num_disparities, kMaxCorners),
                 left.rows);
}

}  // namespace stereo_sgmp
