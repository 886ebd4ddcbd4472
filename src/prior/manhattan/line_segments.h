// Straight edges of an image.
#ifndef STEREO_SGMP_PRIOR_MANHATTAN_LINE_SEGMENTS_H_
#define STEREO_SGMP_PRIOR_MANHATTAN_LINE_SEGMENTS_H_

#include <vector>

#include <Eigen/Core>
#include <opencv2/core.hpp>

namespace stereo_sgmp {

// In pixels, with pixel centres at integer coordinates.
struct LineSegment {
  Eigen::Vector2d start;
  Eigen::Vector2d end;

  double Length() const { return (end - start).norm(); }
};

// The segments of at least 2 % of the image's diagonal, longest first, by OpenCV's LSD (Grompone
// von Gioi et al., PAMI 2010). Large images are reduced first: their long edges stay, and blur and
// noise, which cut them into pieces, go. `image` is CV_8U with 1, 3 or 4 channels; the result is
// in its pixels.
//
// Throws std::invalid_argument where the image has another type, and std::runtime_error where
// OpenCV has no LSD: 4.2 (Ubuntu 20.04) to 4.5.0 left it out.
std::vector<LineSegment> FindLineSegments(const cv::Mat& image);

}  // namespace stereo_sgmp

#endif  // STEREO_SGMP_PRIOR_MANHATTAN_LINE_SEGMENTS_H_
