#include "scene/world_builder.h"

#include <Eigen/Geometry>

namespace stereo_sgmp {

using Eigen::Vector3d;

void WorldBuilder::AddFacingX(double x, double y0, double y1, double z0, double z1,
                              const Material& material) {
  Add({x, y0, z0}, {0, 0, z1 - z0}, {0, y1 - y0, 0}, material);
}

void WorldBuilder::AddFacingY(double x0, double x1, double y, double z0, double z1,
                              const Material& material) {
  Add({x0, y, z0}, {x1 - x0, 0, 0}, {0, 0, z1 - z0}, material);
}

void WorldBuilder::AddFacingZ(double x0, double x1, double y0, double y1, double z,
                              const Material& material) {
  Add({x0, y0, z}, {x1 - x0, 0, 0}, {0, y1 - y0, 0}, material);
}

void WorldBuilder::AddBox(const Vector3d& front_bottom_left, const Vector3d& size,
                          const Material& material) {
  const Vector3d low = front_bottom_left - Vector3d(0.0, size.y(), 0.0);
  const Vector3d high = low + size;
  AddFacingZ(low.x(), high.x(), low.y(), high.y(), low.z(), material);
  AddFacingX(low.x(), low.y(), high.y(), low.z(), high.z(), material);
  AddFacingX(high.x(), low.y(), high.y(), low.z(), high.z(), material);
  AddFacingY(low.x(), high.x(), low.y(), low.z(), high.z(), material);
  AddFacingY(low.x(), high.x(), high.y(), low.z(), high.z(), material);
}

void WorldBuilder::AddSphere(const Vector3d& center, double radius, const Material& material) {
  RoundSurface sphere;
  sphere.shape = RoundSurface::Shape::kSphere;
  sphere.center = center;
  sphere.radius = radius;
  sphere.material = material;
  world_.round_surfaces.push_back(sphere);
}

void WorldBuilder::AddColumn(const Vector3d& center, double radius, double y0, double y1,
                             const Material& material) {
  RoundSurface column;
  column.shape = RoundSurface::Shape::kColumn;
  column.center = {center.x(), (y0 + y1) / 2.0, center.z()};
  column.radius = radius;
  column.half_height = (y1 - y0) / 2.0;
  column.material = material;
  world_.round_surfaces.push_back(column);
}

void WorldBuilder::Turn(double yaw, double pitch, double roll) {
  const Eigen::Matrix3d rotation =
      (Eigen::AngleAxisd(roll, Vector3d::UnitZ()) * Eigen::AngleAxisd(pitch, Vector3d::UnitX()) *
       Eigen::AngleAxisd(yaw, Vector3d::UnitY()))
          .toRotationMatrix();
  for (Patch& patch : world_.patches) {
    patch.origin = rotation * patch.origin;
    patch.edge_u = rotation * patch.edge_u;
    patch.edge_v = rotation * patch.edge_v;
  }
  for (RoundSurface& surface : world_.round_surfaces) {
    surface.center = rotation * surface.center;
    surface.axis = rotation * surface.axis;
  }
  world_.light = rotation * world_.light;
  world_.rotation = rotation * world_.rotation;
}

void WorldBuilder::Add(const Vector3d& origin, const Vector3d& edge_u, const Vector3d& edge_v,
                       const Material& material) {
  world_.patches.push_back({origin, edge_u, edge_v, material});
}

}  // namespace stereo_sgmp
