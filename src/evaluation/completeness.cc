#include "evaluation/completeness.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <limits>

namespace stereo_sgmp {
namespace {

struct Sample {
  float uncertainty;
  bool bad;
};

std::vector<Sample> SortedSamples(const cv::Mat& bad, const cv::Mat& evaluated,
                                  const cv::Mat& uncertainty) {
  std::vector<Sample> samples;
  for (int y = 0; y < evaluated.rows; ++y) {
    for (int x = 0; x < evaluated.cols; ++x) {
      if (evaluated.at<std::uint8_t>(y, x) == 0) continue;
      const float u = uncertainty.at<float>(y, x);
      samples.push_back({std::isnan(u) ? std::numeric_limits<float>::infinity() : u,
                         bad.at<std::uint8_t>(y, x) != 0});
    }
  }
  std::sort(samples.begin(), samples.end(),
            [](const Sample& a, const Sample& b) { return a.uncertainty < b.uncertainty; });
  return samples;
}

}  // namespace

CompletenessCurve::CompletenessCurve(const cv::Mat& bad, const cv::Mat& evaluated,
                                     const cv::Mat& uncertainty)
    : steps_(1) {
  const std::vector<Sample> samples = SortedSamples(bad, evaluated, uncertainty);
  Step step;
  for (std::size_t i = 0; i < samples.size(); ++i) {
    step.pixels += 1.0;
    if (samples[i].bad) step.bad += 1.0;
    const bool group_ends =
        i + 1 == samples.size() || samples[i + 1].uncertainty != samples[i].uncertainty;
    if (group_ends) steps_.push_back(step);
  }
}

double CompletenessCurve::BadAmong(double k, const Step& step, const Step& next) {
  return step.bad + (next.bad - step.bad) * (k - step.pixels) / (next.pixels - step.pixels);
}

double CompletenessCurve::ErrorAt(double completeness) const {
  const double count = steps_.back().pixels;
  if (count == 0.0) return std::numeric_limits<double>::quiet_NaN();
  const double k = std::clamp(std::ceil(completeness * count), 1.0, count);
  const auto next =
      std::lower_bound(steps_.begin(), steps_.end(), k,
                       [](const Step& step, double pixels) { return step.pixels < pixels; });
  return 100.0 * BadAmong(k, *(next - 1), *next) / k;
}

double CompletenessCurve::Area() const {
  const double count = steps_.back().pixels;
  if (count == 0.0) return std::numeric_limits<double>::quiet_NaN();
  double sum = 0.0;
  double k = 1.0;
  for (std::size_t i = 1; i < steps_.size(); ++i) {
    for (; k <= steps_[i].pixels; k += 1.0) sum += BadAmong(k, steps_[i - 1], steps_[i]) / k;
  }
  return 100.0 * sum / count;
}

}  // namespace stereo_sgmp
