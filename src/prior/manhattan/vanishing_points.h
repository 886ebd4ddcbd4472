// The three directions of a Manhattan world from the lines of one image.
#ifndef STEREO_SGMP_PRIOR_MANHATTAN_VANISHING_POINTS_H_
#define STEREO_SGMP_PRIOR_MANHATTAN_VANISHING_POINTS_H_

#include <cstdint>
#include <optional>
#include <vector>

#include <Eigen/Core>

#include "prior/manhattan/line_segments.h"
#include "stereo_sgmp/stereo_camera.h"

namespace stereo_sgmp {

struct ManhattanFrame {
  // A rotation whose columns are the directions of the world in the camera's optical frame: the
  // second is the one nearest to the image's vertical (pointing down), the third of the others
  // the one nearest to the optical axis (pointing forward), the first points right.
  Eigen::Matrix3d directions;
  // Per line: the column it is parallel to, or -1.
  std::vector<std::int8_t> classes;
};

// Two-line exhaustive search (Lu et al., WACV 2017), then least squares over the rotation. The
// lines are in pixels of the camera's image and have a length; those that come first are searched
// where there are many. Deterministic.
//
// None where the lines don't show a Manhattan world: at least two directions need 8 % of the
// length of all lines, the third 3 %, all together half of it.
std::optional<ManhattanFrame> FindManhattanFrame(const std::vector<LineSegment>& lines,
                                                 const StereoCamera& camera);

}  // namespace stereo_sgmp

#endif  // STEREO_SGMP_PRIOR_MANHATTAN_VANISHING_POINTS_H_
