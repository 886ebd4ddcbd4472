#ifndef STEREO_SGMP_SCENE_VIEW_H_
#define STEREO_SGMP_SCENE_VIEW_H_

#include <Eigen/Core>

#include "stereo_sgmp/stereo_camera.h"

namespace stereo_sgmp {

struct PinholeView {
  double focal_length = 0.0;  // pixels
  double cx = 0.0;
  double cy = 0.0;
  Eigen::Vector3d center;  // of projection, in the left camera's optical frame

  // The ray through the pixel (x, y): center + z * Ray(x, y) lies at depth z.
  Eigen::Vector3d Ray(double x, double y) const {
    return {(x - cx) / focal_length, (y - cy) / focal_length, 1.0};
  }
};

// The views of a stereo camera.
inline PinholeView LeftView(const StereoCamera& camera) {
  return {camera.focal_length, camera.cx, camera.cy, Eigen::Vector3d::Zero()};
}
inline PinholeView RightView(const StereoCamera& camera) {
  return {camera.focal_length, camera.cx + camera.doffs, camera.cy,
          Eigen::Vector3d(camera.baseline, 0.0, 0.0)};
}

// Where a ray meets a surface.
struct SurfacePoint {
  double w = 0.0;  // 1 / z, 1/metres; 0 where the ray misses
  double s = 0.0;  // metres along the surface, in its own two directions
  double t = 0.0;
};

}  // namespace stereo_sgmp

#endif  // STEREO_SGMP_SCENE_VIEW_H_
