#include "alignment/template_search.h"

#include <algorithm>
#include <cmath>
#include <cstdint>

#include <opencv2/imgproc.hpp>

namespace stereo_sgmp {
namespace {

constexpr int kSide = 2 * TemplateSearch::kRadius + 1;
constexpr double kPixels = kSide * kSide;
constexpr float kMinCorrelation = 0.8F;
constexpr float kMinDistinctness = 0.05F;  // above the correlation of the second best place
constexpr int kSamePlace = 2;              // columns around the best place that belong to it

}  // namespace

TemplateSearch::TemplateSearch(const cv::Mat& left, const cv::Mat& right, const SearchRange& range)
    : left_(left), range_(range), scores_(right.size()) {
  right.convertTo(right_, CV_32F);
  const cv::Size side(kSide, kSide);
  cv::boxFilter(right, right_sums_, CV_64F, side, cv::Point(-1, -1), false);
  cv::sqrBoxFilter(right, right_squares_, CV_64F, side, cv::Point(-1, -1), false);
}

bool TemplateSearch::Find(cv::Point point, cv::Point* match) {
  const cv::Rect inner(kRadius, kRadius, left_.cols - 2 * kRadius, left_.rows - 2 * kRadius);
  if (!inner.contains(point)) return false;
  const int columns = range_.max_disparity - range_.min_disparity + 1;
  const cv::Rect centres = cv::Rect(point.x - range_.max_disparity, point.y - range_.rows, columns,
                                    2 * range_.rows + 1) &
                           inner;
  if (centres.empty()) return false;
  for (int y = centres.y; y < centres.br().y; ++y) {
    CorrelateRow(point, y, centres.x, centres.br().x);
  }
  const Place best = BestPlace(centres, 0, 0);
  if (best.correlation < kMinCorrelation) return false;
  const Place second =
      BestPlace(centres, best.centre.x - kSamePlace, best.centre.x + kSamePlace + 1);
  if (second.correlation > best.correlation - kMinDistinctness) return false;
  *match = best.centre;
  return true;
}

// Sums of products of gray levels stay below 2^24: floats hold them exactly.
void TemplateSearch::CorrelateRow(cv::Point point, int y, int x_begin, int x_end) {
  float* scores = scores_[y];
  std::fill(scores + x_begin, scores + x_end, 0.0F);
  double sum = 0.0;
  double squares = 0.0;
  for (int dy = -kRadius; dy <= kRadius; ++dy) {
    const std::uint8_t* left = left_.ptr<std::uint8_t>(point.y + dy) + point.x;
    for (int dx = -kRadius; dx <= kRadius; ++dx) {
      const float gray = left[dx];
      const float* right = right_[y + dy] + dx;
      for (int x = x_begin; x < x_end; ++x) scores[x] += gray * right[x];
      sum += gray;
      squares += gray * gray;
    }
  }
  const double left_variance = kPixels * squares - sum * sum;
  for (int x = x_begin; x < x_end; ++x) {
    const double right_sum = right_sums_(y, x);
    const double right_variance = kPixels * right_squares_(y, x) - right_sum * right_sum;
    const double covariance = kPixels * scores[x] - sum * right_sum;
    const double product = left_variance * right_variance;
    scores[x] = product > 0.0 ? static_cast<float>(covariance / std::sqrt(product)) : -1.0F;
  }
}

TemplateSearch::Place TemplateSearch::BestPlace(const cv::Rect& centres, int avoid_begin,
                                                int avoid_end) const {
  Place best;
  for (int y = centres.y; y < centres.br().y; ++y) {
    const float* scores = scores_[y];
    for (int x = centres.x; x < centres.br().x; ++x) {
      const bool avoided = x >= avoid_begin && x < avoid_end;
      if (!avoided && scores[x] > best.correlation) best = {cv::Point(x, y), scores[x]};
    }
  }
  return best;
}

}  // namespace stereo_sgmp
