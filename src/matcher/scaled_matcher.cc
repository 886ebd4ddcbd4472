#include "matcher/scaled_matcher.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <iterator>
#include <vector>

#include <opencv2/imgproc.hpp>

namespace stereo_sgmp {
namespace {

// Neighbours that differ by more are on two surfaces, between which nothing is interpolated.
constexpr float kSurfaceStep = 1.0f;

// Where a pixel of the large image lies among those of the small one.
struct Position {
  Position() = default;
  Position(int index, double scale, int length) {
    const double exact = std::clamp((index + 0.5) * scale - 0.5, 0.0, length - 1.0);
    first = std::min(static_cast<int>(exact), std::max(length - 2, 0));
    second = std::min(first + 1, length - 1);
    share = static_cast<float>(exact - first);
  }

  int nearest() const { return share < 0.5f ? first : second; }

  int first = 0;
  int second = 0;
  float share = 0.0f;  // of the second
};

std::vector<Position> Positions(int small, int large) {
  std::vector<Position> positions(static_cast<std::size_t>(large));
  const double scale = static_cast<double>(small) / large;
  for (int i = 0; i < large; ++i) positions[static_cast<std::size_t>(i)] = {i, scale, small};
  return positions;
}

// Enlarges disparities and multiplies them: linearly within surfaces, without mixing two.
void EnlargeDisparities(const cv::Mat& small, cv::Size size, cv::Mat* large) {
  large->create(size, CV_32F);
  const std::vector<Position> columns = Positions(small.cols, size.width);
  const double scale_y = static_cast<double>(small.rows) / size.height;
  const float factor = static_cast<float>(static_cast<double>(size.width) / small.cols);
  for (int y = 0; y < size.height; ++y) {
    const Position v(y, scale_y, small.rows);
    const float* upper = small.ptr<float>(v.first);
    const float* lower = small.ptr<float>(v.second);
    const float* nearest = small.ptr<float>(v.nearest());
    float* out = large->ptr<float>(y);
    for (int x = 0; x < size.width; ++x) {
      const Position& u = columns[static_cast<std::size_t>(x)];
      const auto [low, high] =
          std::minmax({upper[u.first], upper[u.second], lower[u.first], lower[u.second]});
      const float top = upper[u.first] + u.share * (upper[u.second] - upper[u.first]);
      const float bottom = lower[u.first] + u.share * (lower[u.second] - lower[u.first]);
      const bool one_surface = high - low <= kSurfaceStep;
      out[x] = factor * (one_surface ? top + v.share * (bottom - top) : nearest[u.nearest()]);
    }
  }
}

void EnlargePriors(double factor, PlanePriors* priors) {
  for (PlaneHypothesis& hypothesis : priors->planes) {
    hypothesis.plane = hypothesis.plane.ScaledUp(factor);
    hypothesis.residual *= factor;
  }
}

void EnlargeStatistics(const cv::Mat& reason, double factor, MatchStatistics* statistics) {
  std::fill(std::begin(statistics->reasons), std::end(statistics->reasons), 0);
  for (int y = 0; y < reason.rows; ++y) {
    const std::uint8_t* row = reason.ptr<std::uint8_t>(y);
    for (int x = 0; x < reason.cols; ++x) ++statistics->reasons[row[x]];
  }
  statistics->density = statistics->reasons[0] / static_cast<double>(reason.total());
  statistics->alignment.offset *= factor;
  statistics->alignment.median_offset *= factor;
  statistics->alignment.residual *= factor;
}

void Enlarge(const MatchResult& small, cv::Size size, MatchResult* large) {
  const double factor = static_cast<double>(size.width) / small.dense.cols;
  EnlargeDisparities(small.raw, size, &large->raw);
  EnlargeDisparities(small.dense, size, &large->dense);
  cv::resize(small.reason, large->reason, size, 0.0, 0.0, cv::INTER_NEAREST);
  cv::resize(small.confidence, large->confidence, size, 0.0, 0.0, cv::INTER_LINEAR);
  cv::resize(small.uncertainty, large->uncertainty, size, 0.0, 0.0, cv::INTER_LINEAR);
  large->priors = small.priors;
  EnlargePriors(factor, &large->priors);
  large->statistics = small.statistics;
  EnlargeStatistics(large->reason, factor, &large->statistics);
}

}  // namespace

void ScaledMatcher::Match(const cv::Mat& left, const cv::Mat& right, const MatchInputs& inputs,
                          const Options& options, const LoadLevel& level, MatchResult* result) {
  const cv::Size size = left.size();
  const cv::Size small_size = SizeAtLevel(size, level);
  matcher_.SetOptions(OptionsAtLevel(options, size, level));
  if (small_size == size) return matcher_.Match(left, right, inputs, result);
  MatchInputs small_inputs;
  if (inputs.camera) small_inputs.camera = CameraAtLevel(*inputs.camera, size, level);
  cv::resize(left, left_, small_size, 0.0, 0.0, cv::INTER_AREA);
  cv::resize(right, right_, small_size, 0.0, 0.0, cv::INTER_AREA);
  matcher_.Match(left_, right_, small_inputs, &small_);
  Enlarge(small_, size, result);
}

}  // namespace stereo_sgmp
