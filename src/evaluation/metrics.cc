#include "evaluation/metrics.h"

#include <limits>
#include <stdexcept>

namespace stereo_sgmp {
namespace {

constexpr double kNan = std::numeric_limits<double>::quiet_NaN();

void CheckSameSize(const cv::Mat& a, const cv::Mat& b) {
  if (a.size() == b.size()) return;
  throw std::invalid_argument("A map of " + std::to_string(a.cols) + " x " +
                              std::to_string(a.rows) + " pixels can't be compared with one of " +
                              std::to_string(b.cols) + " x " + std::to_string(b.rows) +
                              "; one size is expected.");
}

}  // namespace

cv::Mat IsFinite(const cv::Mat& values) {
  // False for NaN too, as all comparisons with it are.
  return cv::abs(values) <= std::numeric_limits<float>::max();
}

cv::Mat EvaluatedPixels(const cv::Mat& truth, const cv::Mat& mask, ZeroTruth zero) {
  cv::Mat evaluated = IsFinite(truth);
  if (zero == ZeroTruth::kUnknown) evaluated &= truth > 0.0;
  if (!mask.empty()) {
    CheckSameSize(truth, mask);
    evaluated &= mask == 255;
  }
  return evaluated;
}

cv::Mat BadPixels(const cv::Mat& disparity, const cv::Mat& truth, const cv::Mat& evaluated,
                  const ErrorBound& bound) {
  CheckSameSize(disparity, truth);
  CheckSameSize(evaluated, truth);
  const cv::Mat error = cv::abs(disparity - truth);
  cv::Mat good = error <= bound.pixels;
  if (bound.share > 0.0) good |= error <= bound.share * cv::abs(truth);
  return evaluated & ~good;
}

double PercentOf(const cv::Mat& evaluated, const cv::Mat& mask) {
  CheckSameSize(evaluated, mask);
  const int count = cv::countNonZero(evaluated);
  return count == 0 ? kNan : 100.0 * cv::countNonZero(evaluated & mask) / count;
}

double BadPercent(const cv::Mat& disparity, const cv::Mat& truth, const cv::Mat& evaluated,
                  const ErrorBound& bound) {
  return PercentOf(evaluated, BadPixels(disparity, truth, evaluated, bound));
}

double AverageError(const cv::Mat& disparity, const cv::Mat& truth, const cv::Mat& evaluated) {
  CheckSameSize(disparity, truth);
  CheckSameSize(evaluated, truth);
  const cv::Mat scored = evaluated & IsFinite(disparity);
  if (cv::countNonZero(scored) == 0) return kNan;
  return cv::mean(cv::abs(disparity - truth), scored)[0];
}

}  // namespace stereo_sgmp
