#ifndef STEREO_SGMP_SCENE_PATCH_H_
#define STEREO_SGMP_SCENE_PATCH_H_

#include <vector>

#include <Eigen/Core>
#include <opencv2/core.hpp>

#include "scene/texture.h"

namespace stereo_sgmp {

// What a surface looks like: albedo * (1 + contrast * noise).
struct Material {
  cv::Vec3f albedo{0.5F, 0.5F, 0.5F};  // blue, green, red, 0..1
  float contrast = 0.2F;
  ValueNoise::Octaves octaves;  // lengths in metres
};

// A textured parallelogram in space: the points origin + u * edge_u + v * edge_v, u and v from
// 0 to 1, in metres in the left camera's optical frame. Seen from both sides.
struct Patch {
  Eigen::Vector3d origin;
  Eigen::Vector3d edge_u;
  Eigen::Vector3d edge_v;
  Material material;
};

// Patches with the one light that shines on them.
struct World {
  std::vector<Patch> patches;
  Eigen::Vector3d light{0.0, -1.0, 0.0};
  float ambient = 0.5F;  // share of the light that comes from everywhere, 0..1
};

// A patch seen by a camera. With homogeneous pixel coordinates the inverse depth w = 1 / z and
// u w and v w are linear in x and y, so a ray is tested with three dot products, and f b w is
// the exact disparity.
struct ProjectedPatch {
  struct Linear {
    double dx = 0.0;
    double dy = 0.0;
    double at_origin = 0.0;
    double At(double x, double y) const { return dx * x + dy * y + at_origin; }
  };
  Linear w;   // 1 / z, per metre
  Linear uw;  // u / z
  Linear vw;  // v / z
};

struct PinholeView {
  double focal_length = 0.0;  // pixels
  double cx = 0.0;
  double cy = 0.0;
  Eigen::Vector3d center;  // of projection, in the left camera's optical frame
};

// All patches as `view` sees them, in their order; rays miss one that is seen edge-on.
std::vector<ProjectedPatch> Project(const World& world, const PinholeView& view);

// Where a ray ends. patch < 0: nowhere.
struct Hit {
  int patch = -1;
  double w = 0.0;  // 1 / z, 1/metres
  double u = 0.0;
  double v = 0.0;
};

// The nearest patch on the ray through (x, y), pixels.
Hit CastRay(const std::vector<ProjectedPatch>& patches, double x, double y);

}  // namespace stereo_sgmp

#endif  // STEREO_SGMP_SCENE_PATCH_H_
