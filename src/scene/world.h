#ifndef STEREO_SGMP_SCENE_WORLD_H_
#define STEREO_SGMP_SCENE_WORLD_H_

#include <cstddef>
#include <vector>

#include <Eigen/Core>

#include "scene/patch.h"
#include "scene/round_surface.h"
#include "scene/view.h"

namespace stereo_sgmp {

// Surfaces with the one light that shines on them, in the left camera's optical frame.
struct World {
  std::vector<Patch> patches;
  std::vector<RoundSurface> round_surfaces;
  Eigen::Vector3d light{0.0, -1.0, 0.0};
  float ambient = 0.5F;  // share of the light that comes from everywhere, 0..1
  // Its columns are the directions in which the world is built: right, down and forward.
  Eigen::Matrix3d rotation = Eigen::Matrix3d::Identity();

  // Surfaces are numbered: the patches, then the round ones.
  const Material& MaterialOf(int surface) const;
};

// Where a ray ends. surface < 0: nowhere.
struct Hit {
  int surface = -1;
  SurfacePoint point;
};

// A world seen by a camera. `world` must outlive it.
class WorldView {
 public:
  WorldView(const World& world, const PinholeView& view);

  // The nearest surface on the ray through (x, y), pixels.
  Hit Cast(double x, double y) const;

  // Of a hit of the ray through (x, y):
  Eigen::Vector3d PointAt(const Hit& hit, double x, double y) const;
  Eigen::Vector3d NormalAt(const Hit& hit, double x, double y) const;  // unit, to the camera
  double Footprint(const Hit& hit, double x, double y) const;  // metres of surface to a pixel

  bool IsPlane(int surface) const { return surface < static_cast<int>(patches_.size()); }
  const ProjectedPatch& PatchOf(int surface) const {
    return patches_[static_cast<std::size_t>(surface)];
  }

 private:
  const World& world_;
  PinholeView view_;
  std::vector<ProjectedPatch> patches_;
  std::vector<ProjectedRoundSurface> round_surfaces_;
};

}  // namespace stereo_sgmp

#endif  // STEREO_SGMP_SCENE_WORLD_H_
