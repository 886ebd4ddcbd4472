#include "scene/round_surface.h"

#include <algorithm>
#include <cmath>

#include <Eigen/Geometry>

namespace stereo_sgmp {

Eigen::Vector3d RoundSurface::NormalAt(const Eigen::Vector3d& point) const {
  Eigen::Vector3d offset = point - center;
  if (shape == Shape::kColumn) offset -= axis.dot(offset) * axis;
  return offset.normalized();
}

ProjectedRoundSurface::ProjectedRoundSurface(const RoundSurface& surface, const PinholeView& view)
    : surface_(surface), view_(view), across_(Eigen::Matrix3d::Identity()) {
  if (surface.shape == RoundSurface::Shape::kColumn) {
    across_ -= surface.axis * surface.axis.transpose();
  }
  const Eigen::Vector3d e = view.center - surface.center;
  across_center_ = across_ * e;
  constant_ = e.dot(across_center_) - surface.radius * surface.radius;
  zero_angle_ = surface.axis.unitOrthogonal();
  quarter_angle_ = surface.axis.cross(zero_angle_);
}

// The point center + z r is on the surface where (e + z r).P(e + z r) = radius^2. Divided by z^2
// this is (e.Pe - radius^2) w^2 + 2 (r.Pe) w + r.Pr = 0 with w = 1 / z.
SurfacePoint ProjectedRoundSurface::Cast(double x, double y, double nearest_w) const {
  const Eigen::Vector3d ray = view_.Ray(x, y);
  const double half_linear = ray.dot(across_center_);
  const double discriminant = half_linear * half_linear - constant_ * ray.dot(across_ * ray);
  if (discriminant < 0.0) return {};
  const double root = std::sqrt(discriminant);
  const double w1 = (-half_linear + root) / constant_;
  const double w2 = (-half_linear - root) / constant_;
  for (const double w : {std::max(w1, w2), std::min(w1, w2)}) {
    if (!(w > nearest_w)) break;
    const SurfacePoint point = PointAt(ray, w);
    if (surface_.shape == RoundSurface::Shape::kSphere ||
        std::abs(point.t) <= surface_.half_height) {
      return point;
    }
  }
  return {};
}

double ProjectedRoundSurface::Footprint(const SurfacePoint& point, double x, double y) const {
  const Eigen::Vector3d ray = view_.Ray(x, y);
  const Eigen::Vector3d normal = surface_.NormalAt(view_.center + ray / point.w);
  return ray.norm() / (point.w * view_.focal_length * std::abs(normal.dot(ray.normalized())));
}

SurfacePoint ProjectedRoundSurface::PointAt(const Eigen::Vector3d& ray, double w) const {
  const Eigen::Vector3d offset = view_.center + ray / w - surface_.center;
  const double angle = std::atan2(quarter_angle_.dot(offset), zero_angle_.dot(offset));
  return {w, angle * surface_.radius, surface_.axis.dot(offset)};
}

}  // namespace stereo_sgmp
