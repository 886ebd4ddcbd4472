#ifndef STEREO_SGMP_MATCH_RESULT_H_
#define STEREO_SGMP_MATCH_RESULT_H_

#include <cstdint>
#include <string>
#include <vector>

#include <opencv2/core.hpp>

#include "stereo_sgmp/disparity_plane.h"
#include "stereo_sgmp/options.h"

namespace stereo_sgmp {

// Why a pixel of the filtered disparity is invalid; the first reason that applies, in this order.
enum class InvalidReason : std::uint8_t {
  kValid = 0,
  kRange = 1,        // the winner is the first or last disparity searched
  kBorder = 2,       // the match lies outside the right image
  kUncertainty = 3,  // confidence below FilterOptions::min_confidence
  kLeftRight = 4,    // the right image's own winner disagrees
  kUniqueness = 5,   // another disparity costs nearly as little
  kSpeckle = 6,      // part of a small isolated region
};
inline constexpr int kInvalidReasonCount = 7;

// A plane hypothesis of the estimated prior, in pixels of the full-resolution left image.
struct PlaneHypothesis {
  DisparityPlane plane;
  int support = 0;        // pixels of the coarse disparity map assigned to the plane
  double residual = 0.0;  // root mean square distance of them, full-resolution pixels
};

// The prior that was used. Without planes for Variant::kSgm, kGs, kGni and kGnv.
struct PlanePriors {
  Variant variant = Variant::kSgm;  // kEpv where kMw finds no Manhattan world
  std::string note;                 // a sentence where that is not the variant asked for
  std::vector<PlaneHypothesis> planes;
  // CV_16S at the size of the coarse pass: index into `planes` of the plane that holds at the
  // pixel (kEpi: of its superpixel; kEpv: the one nearest to the coarse disparity), -1 for none.
  cv::Mat labels;
};

struct AlignmentReport {
  bool applied = false;        // the right image was warped by y' = scale * y + offset
  double scale = 1.0;          // a
  double offset = 0.0;         // b, pixels
  int inliers = 0;             // matched features that agree with the model
  double median_offset = 0.0;  // median of |y' - y| before the warp, pixels
  double residual = 0.0;       // median of |y' - (a y + b)| over the inliers, pixels
};

struct StageTime {
  std::string name;
  double ms = 0.0;
};

struct MatchStatistics {
  double frame_ms = 0.0;  // the whole call
  // Wall time of each stage, in order; they sum to frame_ms. Costs that are prepared while planes
  // are found add nothing to it.
  std::vector<StageTime> stages;
  int searched_disparities = 0;           // num_disparities, or fewer with Options::narrow_range
  int planes = 0;                         // number of plane hypotheses
  double density = 0.0;                   // share of the pixels that are valid, 0..1
  int reasons[kInvalidReasonCount] = {};  // pixels per InvalidReason
  AlignmentReport alignment;
};

// Everything of the size of the left image unless said. Disparities are in pixels, positive
// for points in front of infinity: d = x_left - x_right.
struct MatchResult {
  cv::Mat raw;          // CV_32F, the winner with sub-pixel at every pixel, unfiltered
  cv::Mat dense;        // CV_32F, a value at every pixel: holes and occlusions filled, smoothed
  cv::Mat reason;       // CV_8U, InvalidReason; the filtered disparity is `dense` where it is 0
  cv::Mat confidence;   // CV_32F, 0..1, high = good, of the raw winner
  cv::Mat uncertainty;  // CV_32F, U_p of the paper, cost units, 0 = all paths agree
  PlanePriors priors;
  MatchStatistics statistics;
};

// The filtered disparity: `dense` where the pixel is valid, `invalid_value` elsewhere.
void FilteredDisparity(const MatchResult& result, float invalid_value, cv::Mat* disparity);

}  // namespace stereo_sgmp

#endif  // STEREO_SGMP_MATCH_RESULT_H_
