#include "cost/radiometric_fit.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>

#include "common/byte_counts.h"

namespace stereo_sgmp {
namespace {

constexpr std::size_t kMinMatches = 100;
constexpr int kMaxMatches = 10000;  // more do not change the fit, only its time
constexpr int kSaturated = 250;     // gray levels above may be clipped
constexpr int kIterations = 10;
constexpr double kWorthwhile = 0.8;  // of the deviation without a fit
constexpr double kTrustedDeviation = 3.0;
constexpr double kUselessDeviation = 8.0;
constexpr double kMinGain = 0.2;
constexpr double kMaxGain = 5.0;

}  // namespace

void RadiometricFitter::CollectPairs(const cv::Mat& left, const cv::Mat& right,
                                     const cv::Mat& disparity, const cv::Mat& confident) {
  const double pixels = static_cast<double>(left.total());
  const int step = std::max(1, static_cast<int>(std::ceil(std::sqrt(pixels / kMaxMatches))));
  pairs_.clear();
  for (int y = 0; y < left.rows; y += step) {
    for (int x = 0; x < left.cols; x += step) {
      if (confident.at<std::uint8_t>(y, x) == 0) continue;
      const double match = std::round(static_cast<double>(x) - disparity.at<float>(y, x));
      if (!(match >= 0.0 && match < right.cols)) continue;
      const int l = left.at<std::uint8_t>(y, x);
      const int r = right.at<std::uint8_t>(y, static_cast<int>(match));
      if (std::max(l, r) > kSaturated) continue;
      pairs_.push_back({static_cast<float>(l), static_cast<float>(r)});
    }
  }
}

double RadiometricFitter::Error(const GrayPair& pair, const RadiometricFit& fit) {
  return pair.left - fit.gain * pair.right - fit.offset;
}

double RadiometricFitter::MedianDeviation(const RadiometricFit& fit) {
  // Only those in the same half of a gray level as the median are put in order.
  const auto byte_of = [](double deviation) {
    return static_cast<int>(std::min(2.0 * deviation, 255.0));
  };
  deviations_.clear();
  ByteCounts counts;
  for (const GrayPair& pair : pairs_) {
    deviations_.push_back(std::abs(Error(pair, fit)));
    counts.Add(byte_of(deviations_.back()));
  }
  std::size_t rank = deviations_.size() / 2;
  const int byte = counts.Find(&rank);
  const auto end = std::remove_if(deviations_.begin(), deviations_.end(),
                                  [&](double deviation) { return byte_of(deviation) != byte; });
  const auto median = deviations_.begin() + static_cast<std::ptrdiff_t>(rank);
  std::nth_element(deviations_.begin(), median, end);
  return *median;
}

bool RadiometricFitter::Refit(double scale, RadiometricFit* fit) const {
  double w_sum = 0.0, r_sum = 0.0, rr_sum = 0.0, l_sum = 0.0, lr_sum = 0.0;
  for (const GrayPair& pair : pairs_) {
    const double error = Error(pair, *fit) / scale;
    const double w = 1.0 / (1.0 + error * error);
    w_sum += w;
    r_sum += w * pair.right;
    rr_sum += w * pair.right * pair.right;
    l_sum += w * pair.left;
    lr_sum += w * pair.left * pair.right;
  }
  const double determinant = w_sum * rr_sum - r_sum * r_sum;
  if (determinant < 1.0) return false;
  fit->gain = (w_sum * lr_sum - r_sum * l_sum) / determinant;
  fit->offset = (rr_sum * l_sum - r_sum * lr_sum) / determinant;
  return true;
}

RadiometricFit RadiometricFitter::Fit(const cv::Mat& left, const cv::Mat& right,
                                      const cv::Mat& disparity, const cv::Mat& confident) {
  const RadiometricFit identity;
  CollectPairs(left, right, disparity, confident);
  if (pairs_.size() < kMinMatches) return identity;

  RadiometricFit fit;
  constexpr double kUnweighted = 1e9;
  bool solvable = Refit(kUnweighted, &fit);
  for (int i = 1; i < kIterations && solvable; ++i) {
    solvable = Refit(2.0 * MedianDeviation(fit) + 1.0, &fit);
  }
  const bool plausible = fit.gain >= kMinGain && fit.gain <= kMaxGain;
  const double before = MedianDeviation(identity);
  const double after = MedianDeviation(fit);
  const bool keep = plausible && after < kWorthwhile * before;
  RadiometricFit result = keep ? fit : identity;
  const double remaining = keep ? after : before;
  result.ad_weight = std::clamp(
      (kUselessDeviation - remaining) / (kUselessDeviation - kTrustedDeviation), 0.0, 1.0);
  return result;
}

}  // namespace stereo_sgmp
