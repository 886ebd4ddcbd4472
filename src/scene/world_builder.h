#ifndef STEREO_SGMP_SCENE_WORLD_BUILDER_H_
#define STEREO_SGMP_SCENE_WORLD_BUILDER_H_

#include <Eigen/Core>

#include "scene/world.h"

namespace stereo_sgmp {

// Builds a world from patches given by the ranges of their coordinates, x to the right, y down
// and z forward; then turns it as the camera was turned.
class WorldBuilder {
 public:
  // The points origin + u * edge_u + v * edge_v, u and v from 0 to 1.
  void Add(const Eigen::Vector3d& origin, const Eigen::Vector3d& edge_u,
           const Eigen::Vector3d& edge_v, const Material& material);
  void AddFacingX(double x, double y0, double y1, double z0, double z1, const Material& material);
  void AddFacingY(double x0, double x1, double y, double z0, double z1, const Material& material);
  void AddFacingZ(double x0, double x1, double y0, double y1, double z, const Material& material);

  // A box standing on y = front_bottom_left.y().
  void AddBox(const Eigen::Vector3d& front_bottom_left, const Eigen::Vector3d& size,
              const Material& material);

  void AddSphere(const Eigen::Vector3d& center, double radius, const Material& material);
  // An upright column from y0 to y1; center.y() is not used.
  void AddColumn(const Eigen::Vector3d& center, double radius, double y0, double y1,
                 const Material& material);

  void SetLight(const Eigen::Vector3d& light) { world_.light = light; }

  // How all that was added so far lies before the camera, radians: seen turned to the right by
  // `yaw` about the vertical, then downwards by `pitch`, then clockwise by `roll`.
  void Turn(double yaw, double pitch, double roll);

  const World& world() const { return world_; }

 private:
  World world_;
};

}  // namespace stereo_sgmp

#endif  // STEREO_SGMP_SCENE_WORLD_BUILDER_H_
