// Which way surfaces face, by the lines around them.
#ifndef STEREO_SGMP_PRIOR_MANHATTAN_ORIENTATION_MAP_H_
#define STEREO_SGMP_PRIOR_MANHATTAN_ORIENTATION_MAP_H_

#include <cstdint>
#include <vector>

#include <opencv2/core.hpp>

#include "prior/manhattan/line_segments.h"
#include "prior/manhattan/vanishing_points.h"
#include "stereo_sgmp/stereo_camera.h"

namespace stereo_sgmp {

// The orientation map of Lee, Hebert and Kanade (CVPR 2009): each line is swept along each of the
// other two directions, both ways, until it meets a line of the third direction, c, or the horizon
// of the plane it sweeps, whose normal is c. A pixel has the normal c where lines of both other
// directions have swept over it, and where this holds for c alone.
//
// `lines` and `camera` are in pixels of an image of the size `full`; `size` is that of the map.
// Returns CV_16S: the column of frame.directions that is the normal, or -1.
cv::Mat MapOrientations(const std::vector<LineSegment>& lines, const ManhattanFrame& frame,
                        const StereoCamera& camera, cv::Size full, cv::Size size);

}  // namespace stereo_sgmp

#endif  // STEREO_SGMP_PRIOR_MANHATTAN_ORIENTATION_MAP_H_
