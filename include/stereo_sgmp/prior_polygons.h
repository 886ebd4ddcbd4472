// The planes of a prior as pieces of surface in space, for drawing.
#ifndef STEREO_SGMP_PRIOR_POLYGONS_H_
#define STEREO_SGMP_PRIOR_POLYGONS_H_

#include <cstddef>
#include <vector>

#include <Eigen/Core>
#include <opencv2/core.hpp>

#include "stereo_sgmp/match_result.h"
#include "stereo_sgmp/stereo_camera.h"

namespace stereo_sgmp {

// A convex polygon on a plane of a prior.
struct PriorPolygon {
  std::size_t plane = 0;  // index into PlanePriors::planes
  // Corners in the frame and unit of `camera`, at least three, in order.
  std::vector<Eigen::Vector3d> corners;
};

// For each plane that labels some pixels, the convex hull of these pixels, seen on the plane and
// cut off beyond `max_depth`. Planes of which nothing is left are left out. `image_size` is that
// of the left image. Throws as StereoCamera::Check, and std::invalid_argument unless
// max_depth > 0.
std::vector<PriorPolygon> PriorPolygons(const PlanePriors& priors, cv::Size image_size,
                                        const StereoCamera& camera, double max_depth);

}  // namespace stereo_sgmp

#endif  // STEREO_SGMP_PRIOR_POLYGONS_H_
