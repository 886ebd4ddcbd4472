#include "scene/patch.h"

#include <algorithm>
#include <cmath>

#include <Eigen/Geometry>
#include <Eigen/LU>

namespace stereo_sgmp {
namespace {

// direction . r as a function of the pixel (x, y) whose ray is r = ((x-cx)/f, (y-cy)/f, 1).
ProjectedPatch::Linear AlongRays(const Eigen::RowVector3d& direction, const PinholeView& view) {
  const double dx = direction.x() / view.focal_length;
  const double dy = direction.y() / view.focal_length;
  return {dx, dy, direction.z() - dx * view.cx - dy * view.cy};
}

}  // namespace

// The point z r of a ray lies on the patch where z r = (origin - center) + u edge_u + v edge_v,
// so (u w, v w, w) = A^-1 r with A = [edge_u edge_v (origin - center)] and w = 1 / z.
ProjectedPatch::ProjectedPatch(const Patch& patch, const PinholeView& view)
    : length_u_(patch.edge_u.norm()),
      length_v_(patch.edge_v.norm()),
      normal_(patch.edge_u.cross(patch.edge_v).normalized()) {
  Eigen::Matrix3d a;
  a << patch.edge_u, patch.edge_v, patch.origin - view.center;
  Eigen::Matrix3d inverse;
  bool invertible = false;
  a.computeInverseWithCheck(inverse, invertible);
  if (!invertible) return;
  w_ = AlongRays(inverse.row(2), view);
  uw_ = AlongRays(inverse.row(0), view);
  vw_ = AlongRays(inverse.row(1), view);
}

double ProjectedPatch::Footprint(const SurfacePoint& point) const {
  const auto change = [&](const Linear& numerator, double ratio) {
    return (std::abs(numerator.dx - ratio * w_.dx) + std::abs(numerator.dy - ratio * w_.dy)) /
           point.w;
  };
  return std::max(change(uw_, point.s / length_u_) * length_u_,
                  change(vw_, point.t / length_v_) * length_v_);
}

}  // namespace stereo_sgmp
