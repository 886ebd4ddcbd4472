#include "scene/world.h"

namespace stereo_sgmp {

const Material& World::MaterialOf(int surface) const {
  const auto i = static_cast<std::size_t>(surface);
  return i < patches.size() ? patches[i].material : round_surfaces[i - patches.size()].material;
}

WorldView::WorldView(const World& world, const PinholeView& view) : world_(world), view_(view) {
  patches_.reserve(world.patches.size());
  for (const Patch& patch : world.patches) patches_.emplace_back(patch, view);
  round_surfaces_.reserve(world.round_surfaces.size());
  for (const RoundSurface& surface : world.round_surfaces) {
    round_surfaces_.emplace_back(surface, view);
  }
}

Hit WorldView::Cast(double x, double y) const {
  Hit hit;
  int surface = 0;
  const auto cast = [&](const auto& surfaces) {
    for (const auto& candidate : surfaces) {
      const SurfacePoint point = candidate.Cast(x, y, hit.point.w);
      if (point.w > 0.0) hit = {surface, point};
      ++surface;
    }
  };
  cast(patches_);
  cast(round_surfaces_);
  return hit;
}

Eigen::Vector3d WorldView::PointAt(const Hit& hit, double x, double y) const {
  return view_.center + view_.Ray(x, y) / hit.point.w;
}

Eigen::Vector3d WorldView::NormalAt(const Hit& hit, double x, double y) const {
  const auto i = static_cast<std::size_t>(hit.surface);
  const Eigen::Vector3d normal =
      IsPlane(hit.surface)
          ? patches_[i].normal()
          : world_.round_surfaces[i - patches_.size()].NormalAt(PointAt(hit, x, y));
  return normal.dot(view_.Ray(x, y)) > 0.0 ? Eigen::Vector3d(-normal) : normal;
}

double WorldView::Footprint(const Hit& hit, double x, double y) const {
  const auto i = static_cast<std::size_t>(hit.surface);
  return IsPlane(hit.surface) ? patches_[i].Footprint(hit.point)
                              : round_surfaces_[i - patches_.size()].Footprint(hit.point, x, y);
}

}  // namespace stereo_sgmp
