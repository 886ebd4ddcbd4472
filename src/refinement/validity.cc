#include "refinement/validity.h"

#include <cmath>
#include <cstdint>

#include "stereo_sgmp/match_result.h"

namespace stereo_sgmp {
namespace {

// Smoothing may mend a winner that is off by this many tolerances. Further off are the winners in
// occlusions, whose filling would agree with the right image's winners for no good reason.
constexpr double kMendable = 2.0;

// As std::lround, which is slow. `value` is far from the ends of int.
int RoundHalfAway(float value) {
  const int whole = static_cast<int>(value);
  const float rest = value - static_cast<float>(whole);  // exact
  return whole + static_cast<int>(rest >= 0.5f) - static_cast<int>(rest <= -0.5f);
}

// All checks of a pixel are made and the first that applies is chosen: branches would mispredict.
// What the loop needs stands in locals, since the compiler must take stores to `out` for changes of
// anything else.
void FindInvalidInRow(const WinnerMap& map, const std::uint16_t* left_right,
                      const float* disparities, const float* confidences,
                      const FilterOptions& options, int y, std::uint8_t* out) {
  const std::uint16_t* const winners = map.winner[y];
  const std::uint16_t* const right_winners = map.right_winner[y];
  const int width = map.shape.width;
  const int min_disparity = map.shape.min_disparity;
  // Of two disparities, both are ends.
  const int first = map.shape.disparities > 2 ? 0 : -1;
  const int last = map.shape.disparities > 2 ? map.shape.disparities - 1 : -1;
  const double min_confidence = options.min_confidence;
  const bool check_sides = options.lr_tolerance >= 0.0;
  const double tolerance = options.lr_tolerance;
  const double mendable = kMendable * tolerance;
  const auto is_inside = [=](int x) {
    return static_cast<unsigned>(x) < static_cast<unsigned>(width);
  };
  for (int x = 0; x < width; ++x) {
    const int winner = winners[x];
    const float disparity = disparities[x];
    const int match = x - RoundHalfAway(disparity);
    const bool has_match = is_inside(match);
    const int right = right_winners[has_match ? match : 0];
    const double apart = std::abs(right + min_disparity - static_cast<double>(disparity));
    const bool disagree =
        !has_match | (right == WinnerMap::kNone) | (apart > tolerance) | (left_right[x] > mendable);
    InvalidReason reason =
        check_sides & disagree ? InvalidReason::kLeftRight : InvalidReason::kValid;
    reason = confidences[x] < min_confidence ? InvalidReason::kUncertainty : reason;
    reason = is_inside(x - min_disparity - winner) ? reason : InvalidReason::kBorder;
    reason = (winner == first) | (winner == last) ? InvalidReason::kRange : reason;
    out[x] = static_cast<std::uint8_t>(reason);
  }
}

// As OpenCV's StereoSGBM asks for; the last of the reasons.
void FindAmbiguousInRow(const WinnerMap& map, double uniqueness_ratio, int y, std::uint8_t* out) {
  const std::uint16_t* const cost = map.cost[y];
  const std::uint16_t* const second = map.second[y];
  for (int x = 0; x < map.shape.width; ++x) {
    const bool ambiguous =
        second[x] != WinnerMap::kNone && second[x] * (100.0 - uniqueness_ratio) < cost[x] * 100.0;
    if (ambiguous && out[x] == static_cast<std::uint8_t>(InvalidReason::kValid)) {
      out[x] = static_cast<std::uint8_t>(InvalidReason::kUniqueness);
    }
  }
}

}  // namespace

void FindInvalid(const WinnerMap& map, const cv::Mat& left_right, const cv::Mat& disparity,
                 const cv::Mat& confidence, const FilterOptions& options, cv::Mat* reason,
                 ThreadPool* pool) {
  reason->create(map.winner.size(), CV_8U);
  pool->ForRanges(reason->rows, [&](int begin, int end) {
    for (int y = begin; y < end; ++y) {
      std::uint8_t* row = reason->ptr<std::uint8_t>(y);
      FindInvalidInRow(map, left_right.ptr<std::uint16_t>(y), disparity.ptr<float>(y),
                       confidence.ptr<float>(y), options, y, row);
      if (options.uniqueness_ratio > 0.0) FindAmbiguousInRow(map, options.uniqueness_ratio, y, row);
    }
  });
}

}  // namespace stereo_sgmp
