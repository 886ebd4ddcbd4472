// Lines in space as a camera sees them.
#ifndef STEREO_SGMP_TEST_PRIOR_MANHATTAN_PROJECTED_LINES_H_
#define STEREO_SGMP_TEST_PRIOR_MANHATTAN_PROJECTED_LINES_H_

#include <Eigen/Geometry>

#include "prior/manhattan/line_segments.h"
#include "stereo_sgmp/stereo_camera.h"

namespace stereo_sgmp {

inline StereoCamera CameraOf640x480() {
  StereoCamera camera;
  camera.focal_length = 500.0;
  camera.cx = 310.0;
  camera.cy = 250.0;
  camera.doffs = 7.0;
  camera.baseline = 0.1;
  return camera;
}

inline Eigen::Vector2d Projected(const StereoCamera& camera, const Eigen::Vector3d& point) {
  return {camera.focal_length * point.x() / point.z() + camera.cx,
          camera.focal_length * point.y() / point.z() + camera.cy};
}

inline LineSegment Seen(const StereoCamera& camera, const Eigen::Vector3d& start,
                        const Eigen::Vector3d& end) {
  return {Projected(camera, start), Projected(camera, end)};
}

// The rotation whose columns are the axes of a world turned to the right by `yaw`, in a camera
// tilted by `pitch` and rolled by `roll`, degrees.
inline Eigen::Matrix3d Frame(double yaw, double pitch, double roll) {
  constexpr double kDegree = 3.14159265358979323846 / 180.0;
  return (Eigen::AngleAxisd(roll * kDegree, Eigen::Vector3d::UnitZ()) *
          Eigen::AngleAxisd(pitch * kDegree, Eigen::Vector3d::UnitX()) *
          Eigen::AngleAxisd(yaw * kDegree, Eigen::Vector3d::UnitY()))
      .toRotationMatrix();
}

}  // namespace stereo_sgmp

#endif  // STEREO_SGMP_TEST_PRIOR_MANHATTAN_PROJECTED_LINES_H_
