#include "alignment/rig_alignment.h"

#include <algorithm>
#include <cmath>

namespace stereo_sgmp {
namespace {

constexpr int kFirstFrames = 5;
constexpr int kCorners = 600;      // of the very first frame, which has to do alone
constexpr int kMoreCorners = 300;  // of each frame that adds to it
constexpr std::size_t kRememberedFits = 5;
constexpr double kVisibleShift = 0.1;  // pixels; below, a warp would only blur

template <class Function>
double MedianOf(const std::deque<ResidualFit>& fits, const Function& value) {
  std::vector<double> values;
  for (const ResidualFit& fit : fits) values.push_back(value(fit));
  std::sort(values.begin(), values.end());
  const std::size_t middle = values.size() / 2;
  return values.size() % 2 == 1 ? values[middle] : 0.5 * (values[middle - 1] + values[middle]);
}

// The line through the medians of the fits at the first and the last row.
ResidualFit MedianFit(const std::deque<ResidualFit>& fits, int height) {
  ResidualFit result = fits.back();
  const double last = std::max(1, height - 1);
  const double top = MedianOf(fits, [](const ResidualFit& fit) { return fit.b; });
  const double bottom =
      MedianOf(fits, [&](const ResidualFit& fit) { return fit.a * last + fit.b; });
  result.a = (bottom - top) / last;
  result.b = top;
  result.max_shift = std::max(std::abs(top), std::abs(bottom - last));
  return result;
}

bool IsApplied(AlignmentMode mode, const ResidualFit& fit) {
  switch (mode) {
    case AlignmentMode::kOff:
      return false;
    case AlignmentMode::kOn:
      return fit.reliable;
    case AlignmentMode::kAuto:
      return fit.reliable && fit.max_shift >= kVisibleShift;
  }
  return false;
}

}  // namespace

AlignmentReport RigAlignment::Update(const AlignmentOptions& options, const cv::Mat& left,
                                     const cv::Mat& right, int min_disparity, int num_disparities) {
  if (options.mode == AlignmentMode::kOff) return AlignmentReport();
  if (left.size() != size_) Reset();
  size_ = left.size();
  if (frame_ < kFirstFrames) {
    LearnFirst(left, right, min_disparity, num_disparities);
  } else if (options.refresh_interval > 0) {
    Refresh(options.refresh_interval, left, right, min_disparity, num_disparities);
  }
  ++frame_;

  AlignmentReport report;
  report.applied = IsApplied(options.mode, current_);
  report.scale = current_.a;
  report.offset = current_.b;
  report.inliers = current_.inliers;
  report.median_offset = current_.median_offset;
  report.residual = current_.residual;
  return report;
}

void RigAlignment::Reset() { *this = RigAlignment(); }

void RigAlignment::LearnFirst(const cv::Mat& left, const cv::Mat& right, int min_disparity,
                              int num_disparities) {
  const std::vector<RowMatch> matches = FindRowMatches(left, right, min_disparity, num_disparities,
                                                       frame_ == 0 ? kCorners : kMoreCorners);
  first_matches_.insert(first_matches_.end(), matches.begin(), matches.end());
  fits_.clear();
  Adopt(FitRows(first_matches_, left.rows));
}

void RigAlignment::Refresh(int interval, const cv::Mat& left, const cv::Mat& right,
                           int min_disparity, int num_disparities) {
  if (refresh_.valid() && frame_ >= adopt_at_) Adopt(refresh_.get());
  if (refresh_.valid() || (frame_ - kFirstFrames) % interval != interval - 1) return;
  // The caller's images may change before the fit is done.
  refresh_ =
      std::async(std::launch::async, [=, left_copy = left.clone(), right_copy = right.clone()] {
        return FitRectificationResidual(left_copy, right_copy, min_disparity, num_disparities);
      });
  adopt_at_ = frame_ + std::max(1, interval / 2);
}

void RigAlignment::Adopt(const ResidualFit& fit) {
  if (!fit.reliable) {
    // Without any better knowledge it still says what was seen.
    if (fits_.empty()) current_ = fit;
    return;
  }
  fits_.push_back(fit);
  if (fits_.size() > kRememberedFits) fits_.pop_front();
  current_ = MedianFit(fits_, size_.height);
}

}  // namespace stereo_sgmp
