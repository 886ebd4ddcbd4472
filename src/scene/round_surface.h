#ifndef STEREO_SGMP_SCENE_ROUND_SURFACE_H_
#define STEREO_SGMP_SCENE_ROUND_SURFACE_H_

#include <Eigen/Core>

#include "scene/texture.h"
#include "scene/view.h"

namespace stereo_sgmp {

// A sphere, or a round column without ends, in metres in the left camera's optical frame. Seen
// from both sides: a column around the camera is a room's curved wall.
struct RoundSurface {
  enum class Shape { kSphere, kColumn };
  Shape shape = Shape::kSphere;
  Eigen::Vector3d center;
  Eigen::Vector3d axis{0.0, 1.0, 0.0};  // unit vector
  double radius = 1.0;
  double half_height = 1.0;  // of a column, to both sides of its centre along the axis
  Material material;

  // Of unit length, outwards.
  Eigen::Vector3d NormalAt(const Eigen::Vector3d& point) const;
};

// A round surface seen by a camera.
class ProjectedRoundSurface {
 public:
  ProjectedRoundSurface(const RoundSurface& surface, const PinholeView& view);

  // Where the ray through (x, y), pixels, meets the surface if that is nearer than 1 / nearest_w.
  SurfacePoint Cast(double x, double y, double nearest_w) const;

  // Metres of surface from one pixel to the next, where it is most foreshortened.
  double Footprint(const SurfacePoint& point, double x, double y) const;

 private:
  SurfacePoint PointAt(const Eigen::Vector3d& ray, double w) const;

  RoundSurface surface_;
  PinholeView view_;
  Eigen::Matrix3d across_;         // P: takes a column's offsets from its axis, all of a sphere's
  Eigen::Vector3d across_center_;  // P e, e from the surface's centre to the camera's
  double constant_;                // e.Pe - r^2
  Eigen::Vector3d zero_angle_;     // directions around the axis where s is 0 and a quarter turn
  Eigen::Vector3d quarter_angle_;
};

}  // namespace stereo_sgmp

#endif  // STEREO_SGMP_SCENE_ROUND_SURFACE_H_
