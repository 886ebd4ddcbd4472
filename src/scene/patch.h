#ifndef STEREO_SGMP_SCENE_PATCH_H_
#define STEREO_SGMP_SCENE_PATCH_H_

#include <Eigen/Core>

#include "scene/texture.h"
#include "scene/view.h"

namespace stereo_sgmp {

// A textured parallelogram in space: the points origin + u * edge_u + v * edge_v, u and v from
// 0 to 1, in metres in the left camera's optical frame. Seen from both sides.
struct Patch {
  Eigen::Vector3d origin;
  Eigen::Vector3d edge_u;
  Eigen::Vector3d edge_v;
  Material material;
};

// A patch seen by a camera. With homogeneous pixel coordinates the inverse depth w = 1 / z and
// u w and v w are linear in x and y, so a ray is tested with three dot products, and f b w is
// the exact disparity.
class ProjectedPatch {
 public:
  struct Linear {
    double dx = 0.0;
    double dy = 0.0;
    double at_origin = 0.0;
    double At(double x, double y) const { return dx * x + dy * y + at_origin; }
  };

  // Rays miss a patch that is seen edge-on.
  ProjectedPatch(const Patch& patch, const PinholeView& view);

  // Where the ray through (x, y), pixels, meets the patch if that is nearer than 1 / nearest_w.
  SurfacePoint Cast(double x, double y, double nearest_w) const {
    const double w = w_.At(x, y);
    if (!(w > nearest_w)) return {};
    const double uw = uw_.At(x, y);
    const double vw = vw_.At(x, y);
    if (uw < 0.0 || uw > w || vw < 0.0 || vw > w) return {};
    return {w, uw / w * length_u_, vw / w * length_v_};
  }

  // Metres of the patch from one pixel to the next, along its most foreshortened edge.
  double Footprint(const SurfacePoint& point) const;

  // 1 / z of the patch's plane, per metre.
  const Linear& inverse_depth() const { return w_; }
  // Of unit length, to either side.
  const Eigen::Vector3d& normal() const { return normal_; }

 private:
  Linear w_;
  Linear uw_;  // u / z
  Linear vw_;  // v / z
  double length_u_;
  double length_v_;
  Eigen::Vector3d normal_;
};

}  // namespace stereo_sgmp

#endif  // STEREO_SGMP_SCENE_PATCH_H_
