#include "refinement/validity.h"

#include <cstdint>

#include "refinement/left_right.h"
#include "stereo_sgmp/match_result.h"

namespace stereo_sgmp {
namespace {

// Smoothing may mend a winner that is off by this many tolerances. Further off are the winners in
// occlusions, whose filling would agree with the right image's winners for no good reason.
constexpr double kMendable = 2.0;

// The checks of one row of pixels.
class RowChecks {
 public:
  RowChecks(const WinnerMap& map, const cv::Mat& disparity, const cv::Mat& confidence,
            const FilterOptions& options, int y)
      : options_(options),
        last_(map.shape.disparities - 1),
        winner_(map.winner[y]),
        cost_(map.cost[y]),
        second_(map.second[y]),
        disparity_(disparity.ptr<float>(y)),
        confidence_(confidence.ptr<float>(y)),
        left_right_(map, y) {}

  InvalidReason At(int x) const {
    if (IsAtRangeEnd(x)) return InvalidReason::kRange;
    if (!left_right_.IsMatchInside(x)) return InvalidReason::kBorder;
    if (confidence_[x] < options_.min_confidence) return InvalidReason::kUncertainty;
    if (DoSidesDisagree(x)) return InvalidReason::kLeftRight;
    if (IsAmbiguous(x)) return InvalidReason::kUniqueness;
    return InvalidReason::kValid;
  }

 private:
  bool IsAtRangeEnd(int x) const { return last_ > 1 && (winner_[x] == 0 || winner_[x] == last_); }

  bool DoSidesDisagree(int x) const {
    if (options_.lr_tolerance < 0.0) return false;
    return left_right_.DifferenceTo(disparity_[x], x) > options_.lr_tolerance ||
           left_right_.Difference(x, WinnerMap::kNone) > kMendable * options_.lr_tolerance;
  }

  bool IsAmbiguous(int x) const {
    return options_.uniqueness_ratio > 0.0 && second_[x] != WinnerMap::kNone &&
           second_[x] * (100.0 - options_.uniqueness_ratio) < cost_[x] * 100.0;
  }

  const FilterOptions& options_;
  const int last_;
  const std::uint16_t* const winner_;
  const std::uint16_t* const cost_;
  const std::uint16_t* const second_;
  const float* const disparity_;
  const float* const confidence_;
  const LeftRightRow left_right_;
};

}  // namespace

void FindInvalid(const WinnerMap& map, const cv::Mat& disparity, const cv::Mat& confidence,
                 const FilterOptions& options, cv::Mat* reason, ThreadPool* pool) {
  reason->create(map.winner.size(), CV_8U);
  pool->ForRanges(reason->rows, [&](int begin, int end) {
    for (int y = begin; y < end; ++y) {
      const RowChecks checks(map, disparity, confidence, options, y);
      std::uint8_t* row = reason->ptr<std::uint8_t>(y);
      for (int x = 0; x < reason->cols; ++x) row[x] = static_cast<std::uint8_t>(checks.At(x));
    }
  });
}

}  // namespace stereo_sgmp
