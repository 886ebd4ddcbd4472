#include "alignment/subpixel_match.h"

#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>

namespace stereo_sgmp {
namespace {

constexpr int kRadius = 7;
constexpr int kSide = 2 * kRadius + 1;
constexpr std::size_t kPixels = kSide * kSide;
constexpr int kIterations = 15;
constexpr double kConverged = 0.01;  // pixels
constexpr double kMaxMove = 2.0;     // pixels
constexpr double kMinCorrelation = 0.85;
constexpr double kMinDeterminant = 1e-3;  // of the structure tensor, relative to its trace squared

using Patch = std::array<double, kPixels>;

bool HoldsPatch(const cv::Mat& image, double x, double y) {
  const int margin = kRadius + 1;  // the gradient or the interpolation needs one more
  return x >= margin && y >= margin && x < image.cols - margin - 1 && y < image.rows - margin - 1;
}

void Sample(const cv::Mat& image, double x, double y, Patch* patch) {
  const int x0 = static_cast<int>(std::floor(x));
  const int y0 = static_cast<int>(std::floor(y));
  const double fx = x - x0;
  const double fy = y - y0;
  std::size_t i = 0;
  for (int dy = -kRadius; dy <= kRadius; ++dy) {
    const std::uint8_t* upper = image.ptr<std::uint8_t>(y0 + dy) + x0;
    const std::uint8_t* lower = image.ptr<std::uint8_t>(y0 + dy + 1) + x0;
    for (int dx = -kRadius; dx <= kRadius; ++dx) {
      const double above = upper[dx] + fx * (upper[dx + 1] - upper[dx]);
      const double below = lower[dx] + fx * (lower[dx + 1] - lower[dx]);
      (*patch)[i++] = above + fy * (below - above);
    }
  }
}

double Dot(const Patch& a, const Patch& b) {
  double sum = 0.0;
  for (std::size_t i = 0; i < kPixels; ++i) sum += a[i] * b[i];
  return sum;
}

void RemoveMean(Patch* patch) {
  double sum = 0.0;
  for (const double value : *patch) sum += value;
  for (double& value : *patch) value -= sum / static_cast<double>(kPixels);
}

// The patch of the left image and its gradients, each less its mean.
struct Template {
  Patch gray;
  Patch gradient_x;
  Patch gradient_y;
};

Template MakeTemplate(const cv::Mat& image, cv::Point point) {
  Template result;
  std::size_t i = 0;
  for (int y = point.y - kRadius; y <= point.y + kRadius; ++y) {
    const std::uint8_t* row = image.ptr<std::uint8_t>(y);
    for (int x = point.x - kRadius; x <= point.x + kRadius; ++x, ++i) {
      result.gray[i] = row[x];
      result.gradient_x[i] = 0.5 * (row[x + 1] - row[x - 1]);
      result.gradient_y[i] =
          0.5 * (image.at<std::uint8_t>(y + 1, x) - image.at<std::uint8_t>(y - 1, x));
    }
  }
  RemoveMean(&result.gray);
  RemoveMean(&result.gradient_x);
  RemoveMean(&result.gradient_y);
  return result;
}

}  // namespace

bool RefineMatch(const cv::Mat& left, const cv::Mat& right, cv::Point point, cv::Point2d* match) {
  if (!HoldsPatch(left, point.x, point.y)) return false;
  const Template model = MakeTemplate(left, point);
  const double xx = Dot(model.gradient_x, model.gradient_x);
  const double xy = Dot(model.gradient_x, model.gradient_y);
  const double yy = Dot(model.gradient_y, model.gradient_y);
  const double determinant = xx * yy - xy * xy;
  if (!(determinant > kMinDeterminant * (xx + yy) * (xx + yy))) return false;
  const double model_energy = Dot(model.gray, model.gray);

  const cv::Point2d start = *match;
  Patch patch;
  for (int i = 0; i < kIterations; ++i) {
    if (!HoldsPatch(right, match->x, match->y)) return false;
    Sample(right, match->x, match->y, &patch);
    RemoveMean(&patch);
    const double energy = Dot(patch, patch);
    if (!(energy > 0.0)) return false;
    const double gain = std::sqrt(model_energy / energy);
    const double correlation = Dot(patch, model.gray) / std::sqrt(energy * model_energy);
    for (std::size_t k = 0; k < kPixels; ++k) patch[k] = gain * patch[k] - model.gray[k];
    const double ex = Dot(patch, model.gradient_x);
    const double ey = Dot(patch, model.gradient_y);
    const cv::Point2d step((yy * ex - xy * ey) / determinant, (xx * ey - xy * ex) / determinant);
    *match -= step;
    if (cv::norm(*match - start) > kMaxMove) return false;
    if (cv::norm(step) < kConverged) return correlation >= kMinCorrelation;
  }
  return false;
}

}  // namespace stereo_sgmp
