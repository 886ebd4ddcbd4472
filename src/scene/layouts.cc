#include "scene/layouts.h"

#include <random>

#include <Eigen/Geometry>

namespace stereo_sgmp {
namespace {

using Eigen::Vector3d;

constexpr double kDegree = 3.14159265358979323846 / 180.0;

class Random {
 public:
  explicit Random(std::uint64_t seed) : bits_(static_cast<std::uint32_t>(seed ^ (seed >> 32))) {}

  double Uniform(double low, double high) {
    constexpr double kRange = 4294967296.0;  // 2^32
    return low + (high - low) * (static_cast<double>(bits_()) / kRange);
  }

 private:
  std::mt19937 bits_;
};

Material Weak(const cv::Vec3f& albedo) { return {albedo, 0.05F, {6, 2.0F, 0.7F}}; }
Material Strong(const cv::Vec3f& albedo) { return {albedo, 0.25F, {8, 4.0F, 0.85F}}; }

// Adds patches given by the ranges of their coordinates.
class Builder {
 public:
  void AddFacingZ(double x0, double x1, double y0, double y1, double z, const Material& material) {
    Add({x0, y0, z}, {x1 - x0, 0, 0}, {0, y1 - y0, 0}, material);
  }
  void AddFacingX(double x, double y0, double y1, double z0, double z1, const Material& material) {
    Add({x, y0, z0}, {0, 0, z1 - z0}, {0, y1 - y0, 0}, material);
  }
  void AddFacingY(double x0, double x1, double y, double z0, double z1, const Material& material) {
    Add({x0, y, z0}, {x1 - x0, 0, 0}, {0, 0, z1 - z0}, material);
  }

  // A box standing on y = bottom.
  void AddBox(const Vector3d& front_bottom_left, const Vector3d& size, const Material& material) {
    const Vector3d low(front_bottom_left.x(), front_bottom_left.y() - size.y(),
                       front_bottom_left.z());
    const Vector3d high = low + size;
    AddFacingZ(low.x(), high.x(), low.y(), high.y(), low.z(), material);
    AddFacingX(low.x(), low.y(), high.y(), low.z(), high.z(), material);
    AddFacingX(high.x(), low.y(), high.y(), low.z(), high.z(), material);
    AddFacingY(low.x(), high.x(), low.y(), low.z(), high.z(), material);
    AddFacingY(low.x(), high.x(), high.y(), low.z(), high.z(), material);
  }

  void Add(const Vector3d& origin, const Vector3d& edge_u, const Vector3d& edge_v,
           const Material& material) {
    world_.patches.push_back({origin, edge_u, edge_v, material});
  }

  // Turns all that was added so far about the camera's vertical axis, to the right.
  void Turn(double angle) {
    const Eigen::Matrix3d rotation = Eigen::AngleAxisd(angle, Vector3d::UnitY()).toRotationMatrix();
    for (Patch& patch : world_.patches) {
      patch.origin = rotation * patch.origin;
      patch.edge_u = rotation * patch.edge_u;
      patch.edge_v = rotation * patch.edge_v;
    }
    world_.light = rotation * world_.light;
  }

  World& world() { return world_; }

 private:
  World world_;
};

// Doors and skirting boards: the few edges of a corridor. They stand out of the wall by less
// than a disparity is measured to.
void AddDoors(double wall_x, double floor, Random* random, Builder* builder) {
  constexpr double kProud = 0.002;
  const double x = wall_x - (wall_x > 0 ? kProud : -kProud);
  double z = random->Uniform(2.2, 3.2);
  while (z < 10.0) {
    builder->AddFacingX(x, floor - 2.05, floor, z, z + 0.9, Weak({0.30F, 0.38F, 0.46F}));
    z += random->Uniform(2.8, 3.6);
  }
  builder->AddFacingX(x, floor - 0.1, floor, 0.5, 12.0, Weak({0.25F, 0.25F, 0.27F}));
}

}  // namespace

World CorridorWorld(std::uint64_t seed) {
  constexpr double kHalfWidth = 1.2;
  constexpr double kFloor = 1.3;
  constexpr double kCeiling = -1.2;
  constexpr double kEnd = 12.0;
  Random random(seed);
  Builder builder;
  builder.AddFacingX(-kHalfWidth, kCeiling, kFloor, -1, kEnd, Weak({0.62F, 0.66F, 0.68F}));
  builder.AddFacingX(kHalfWidth, kCeiling, kFloor, -1, kEnd, Weak({0.60F, 0.64F, 0.66F}));
  builder.AddFacingY(-kHalfWidth, kHalfWidth, kFloor, -1, kEnd, Weak({0.36F, 0.40F, 0.44F}));
  builder.AddFacingY(-kHalfWidth, kHalfWidth, kCeiling, -1, kEnd, Weak({0.74F, 0.75F, 0.76F}));
  builder.AddFacingZ(-kHalfWidth, kHalfWidth, kCeiling, kFloor, kEnd, Weak({0.5F, 0.52F, 0.55F}));
  AddDoors(-kHalfWidth, kFloor, &random, &builder);
  AddDoors(kHalfWidth, kFloor, &random, &builder);
  builder.world().light = {random.Uniform(-0.5, 0.5), kCeiling + 0.3, random.Uniform(3.0, 5.0)};
  builder.Turn(random.Uniform(4.0, 8.0) * kDegree);
  return builder.world();
}

World RoomWorld(std::uint64_t seed) {
  constexpr double kFloor = 1.2;
  constexpr double kTable = 0.45;  // height of its top
  Random random(seed);
  Builder builder;
  builder.AddFacingY(-3, 3, kFloor, -1, 5, Strong({0.30F, 0.38F, 0.48F}));
  builder.AddFacingY(-3, 3, -1.4, -1, 5, Weak({0.75F, 0.75F, 0.75F}));
  builder.AddFacingX(-2.2, -1.4, kFloor, -1, 5, Weak({0.62F, 0.70F, 0.66F}));
  builder.AddFacingX(2.2, -1.4, kFloor, -1, 5, Weak({0.66F, 0.66F, 0.70F}));
  builder.AddFacingZ(-3, 3, -1.4, kFloor, 4.5, Weak({0.60F, 0.64F, 0.68F}));
  const double x = random.Uniform(-1.3, -1.0);
  builder.AddBox({x, kTable + 0.04, 2.4}, {1.3, 0.04, 0.8}, Weak({0.30F, 0.42F, 0.55F}));
  for (const double leg_x : {x + 0.05, x + 1.2}) {
    for (const double leg_z : {2.45, 3.1}) {
      builder.AddBox({leg_x, kFloor, leg_z}, {0.05, kFloor - kTable, 0.05},
                     Weak({0.25F, 0.33F, 0.42F}));
    }
  }
  builder.AddBox({x + 0.2, kTable, 2.6}, {0.3, 0.25, 0.2}, Strong({0.30F, 0.35F, 0.70F}));
  builder.AddBox({x + 0.8, kTable, 2.7}, {0.2, 0.4, 0.2}, Strong({0.55F, 0.45F, 0.30F}));
  builder.AddBox({0.3, kFloor, random.Uniform(2.6, 3.2)}, {0.7, 0.9, 0.6},
                 Weak({0.40F, 0.50F, 0.60F}));
  builder.world().light = {0.0, -1.3, 2.0};
  builder.Turn(random.Uniform(10.0, 18.0) * kDegree);
  return builder.world();
}

World FrontoParallelWorld(std::uint64_t seed) {
  constexpr int kBoxes = 7;
  Random random(seed);
  Builder builder;
  builder.AddFacingZ(-30, 30, -30, 30, 6.0, Strong({0.55F, 0.58F, 0.60F}));
  for (int i = 0; i < kBoxes; ++i) {
    const double z = random.Uniform(2.5, 5.0);
    const double x = z * (0.17 * (i - 3) + random.Uniform(-0.08, 0.02));
    const double y = z * random.Uniform(-0.3, 0.05);
    const cv::Vec3f albedo(0.3F + 0.05F * static_cast<float>(i), 0.5F,
                           0.6F - 0.05F * static_cast<float>(i));
    builder.AddFacingZ(x, x + random.Uniform(0.4, 0.9), y, y + random.Uniform(0.4, 0.9), z,
                       i % 2 == 0 ? Strong(albedo) : Weak(albedo));
  }
  builder.world().light = {1.0, -3.0, 0.0};
  return builder.world();
}

World FenceWorld(std::uint64_t seed) {
  constexpr double kBarWidth = 0.04;
  constexpr double kBarDepth = 2.5;
  Random random(seed);
  Builder builder;
  builder.AddFacingZ(-40, 40, -40, 40, random.Uniform(3.8, 4.2), Strong({0.5F, 0.56F, 0.6F}));
  builder.Turn(random.Uniform(25.0, 32.0) * kDegree);
  for (double x = -4.0; x < 4.0; x += random.Uniform(0.22, 0.28)) {
    builder.AddFacingZ(x, x + kBarWidth, -10, 10, kBarDepth, Strong({0.25F, 0.28F, 0.32F}));
  }
  builder.world().light = {-1.0, -3.0, 0.0};
  return builder.world();
}

}  // namespace stereo_sgmp
