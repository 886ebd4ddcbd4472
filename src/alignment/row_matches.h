#ifndef STEREO_SGMP_ALIGNMENT_ROW_MATCHES_H_
#define STEREO_SGMP_ALIGNMENT_ROW_MATCHES_H_

#include <vector>

#include <opencv2/core.hpp>

namespace stereo_sgmp {

// The row of a point in the left and in the right image, pixels.
struct RowMatch {
  double left = 0.0;
  double right = 0.0;
};

// Matches corners of the left image to the right one, without trust in the rows: up to
// max_corners points, to about 0.1 pixels. Images: CV_8UC1 of one size. Wrong matches occur.
// Deterministic; empty for images too small or too flat.
std::vector<RowMatch> FindRowMatches(const cv::Mat& left, const cv::Mat& right, int min_disparity,
                                     int num_disparities, int max_corners);

}  // namespace stereo_sgmp

#endif  // STEREO_SGMP_ALIGNMENT_ROW_MATCHES_H_
