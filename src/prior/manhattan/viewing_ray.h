#ifndef STEREO_SGMP_PRIOR_MANHATTAN_VIEWING_RAY_H_
#define STEREO_SGMP_PRIOR_MANHATTAN_VIEWING_RAY_H_

#include <Eigen/Core>

#include "stereo_sgmp/stereo_camera.h"

namespace stereo_sgmp {

// (u, v, f) of the paper: the direction in which the camera sees the pixel (x, y), of depth f.
inline Eigen::Vector3d ViewingRay(const StereoCamera& camera, double x, double y) {
  return {x - camera.cx, y - camera.cy, camera.focal_length};
}

}  // namespace stereo_sgmp

#endif  // STEREO_SGMP_PRIOR_MANHATTAN_VIEWING_RAY_H_
