#include "scene/patch.h"

#include <cmath>
#include <cstddef>

#include <Eigen/LU>

namespace stereo_sgmp {
namespace {

// direction . r as a function of the pixel (x, y) whose ray is r = ((x-cx)/f, (y-cy)/f, 1).
ProjectedPatch::Linear AlongRays(const Eigen::RowVector3d& direction, const PinholeView& view) {
  const double dx = direction.x() / view.focal_length;
  const double dy = direction.y() / view.focal_length;
  return {dx, dy, direction.z() - dx * view.cx - dy * view.cy};
}

// The point z r of a ray lies on the patch where z r = (origin - center) + u edge_u + v edge_v,
// so (u w, v w, w) = A^-1 r with A = [edge_u edge_v (origin - center)] and w = 1 / z.
ProjectedPatch Project(const Patch& patch, const PinholeView& view) {
  Eigen::Matrix3d a;
  a << patch.edge_u, patch.edge_v, patch.origin - view.center;
  Eigen::Matrix3d inverse;
  bool invertible = false;
  a.computeInverseWithCheck(inverse, invertible);
  if (!invertible) return {};
  return {AlongRays(inverse.row(2), view), AlongRays(inverse.row(0), view),
          AlongRays(inverse.row(1), view)};
}

}  // namespace

std::vector<ProjectedPatch> Project(const World& world, const PinholeView& view) {
  std::vector<ProjectedPatch> projected;
  projected.reserve(world.patches.size());
  for (const Patch& patch : world.patches) projected.push_back(Project(patch, view));
  return projected;
}

Hit CastRay(const std::vector<ProjectedPatch>& patches, double x, double y) {
  Hit hit;
  for (std::size_t i = 0; i < patches.size(); ++i) {
    const double w = patches[i].w.At(x, y);
    if (!(w > hit.w)) continue;
    const double uw = patches[i].uw.At(x, y);
    const double vw = patches[i].vw.At(x, y);
    if (uw < 0.0 || uw > w || vw < 0.0 || vw > w) continue;
    hit = {static_cast<int>(i), w, uw, vw};
  }
  if (hit.patch >= 0) {
    hit.u /= hit.w;
    hit.v /= hit.w;
  }
  return hit;
}

}  // namespace stereo_sgmp
