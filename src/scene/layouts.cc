#include "scene/layouts.h"

#include <random>

#include "scene/world_builder.h"

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

// Weakly textured surfaces have detail at all scales, from stains of half a metre down to a grain
// of 2 mm, with a spectrum (f^-1.5 in amplitude) a little steeper than the 1 / f of most pictures.
// The stains are a gray level or two deep, which survives shrinking the picture; the grain, of
// which a matcher at full resolution has to live, is less than the noise of a sensor.
constexpr float kFalloff = 0.7F;  // of the amplitude from one octave to the next

// A plastered and painted wall: a standard deviation of 1 % in the first octave.
Material Plaster(const cv::Vec3f& albedo) { return {albedo, 0.035F, {9, 2.0F, kFalloff}}; }
// Wood, linoleum, ceilings: a little more contrast, as they get less light.
Material Smooth(const cv::Vec3f& albedo) { return {albedo, 0.055F, {9, 2.0F, kFalloff}}; }
// Carpets, cardboard, stone: easy to match.
Material Rough(const cv::Vec3f& albedo) { return {albedo, 0.25F, {8, 4.0F, 0.85F}}; }

// Things flat on a wall stand out of it by less than a disparity is measured to.
constexpr double kSkirtingProud = 0.001;
constexpr double kFrameProud = 0.0015;
constexpr double kLeafProud = 0.002;

const cv::Vec3f kWood(0.30F, 0.38F, 0.46F);
const cv::Vec3f kFrame(0.84F, 0.86F, 0.88F);
const cv::Vec3f kSkirting(0.82F, 0.83F, 0.84F);

struct Range {
  double low;
  double high;

  Range Grown(double by) const { return {low - by, high + by}; }
};

// A leaf (a door, a picture, a pane) in its frame on a wall that faces x = 0.
void AddFramedOnX(double wall_x, Range y, Range z, double frame, const Material& leaf,
                  WorldBuilder* builder) {
  const double side = wall_x > 0.0 ? -1.0 : 1.0;
  const Range outer_y = y.Grown(frame);
  const Range outer_z = z.Grown(frame);
  builder->AddFacingX(wall_x + side * kFrameProud, outer_y.low, outer_y.high, outer_z.low,
                      outer_z.high, Smooth(kFrame));
  builder->AddFacingX(wall_x + side * kLeafProud, y.low, y.high, z.low, z.high, leaf);
}

// The same on a wall that faces the camera.
void AddFramedOnZ(Range x, Range y, double wall_z, double frame, const Material& leaf,
                  WorldBuilder* builder) {
  const Range outer_x = x.Grown(frame);
  const Range outer_y = y.Grown(frame);
  builder->AddFacingZ(outer_x.low, outer_x.high, outer_y.low, outer_y.high, wall_z - kFrameProud,
                      Smooth(kFrame));
  builder->AddFacingZ(x.low, x.high, y.low, y.high, wall_z - kLeafProud, leaf);
}

// A skirting board and, every few metres, a door.
void AddDoors(double wall_x, double floor, Random* random, WorldBuilder* builder) {
  const double skirting_x = wall_x + (wall_x > 0.0 ? -kSkirtingProud : kSkirtingProud);
  builder->AddFacingX(skirting_x, floor - 0.1, floor, 0.5, 12.0, Smooth(kSkirting));
  double z = random->Uniform(2.2, 3.2);
  while (z < 10.0) {
    AddFramedOnX(wall_x, {floor - 2.05, floor}, {z, z + 0.9}, 0.06, Smooth(kWood), builder);
    z += random->Uniform(2.8, 3.6);
  }
}

void AddTable(double x, double z, double floor, double top, WorldBuilder* builder) {
  constexpr double kThickness = 0.04;
  builder->AddBox({x, top + kThickness, z}, {1.3, kThickness, 0.8}, Smooth({0.50F, 0.62F, 0.72F}));
  for (const double leg_x : {x + 0.05, x + 1.2}) {
    for (const double leg_z : {z + 0.05, z + 0.7}) {
      builder->AddBox({leg_x, floor, leg_z}, {0.05, floor - top - kThickness, 0.05},
                      Smooth({0.45F, 0.55F, 0.65F}));
    }
  }
}

}  // namespace

World CorridorWorld(std::uint64_t seed) {
  constexpr double kHalfWidth = 1.2;
  constexpr double kFloor = 1.3;
  constexpr double kCeiling = -1.2;
  constexpr double kEnd = 12.0;
  Random random(seed);
  WorldBuilder builder;
  builder.AddFacingX(-kHalfWidth, kCeiling, kFloor, -1, kEnd, Plaster({0.62F, 0.66F, 0.68F}));
  builder.AddFacingX(kHalfWidth, kCeiling, kFloor, -1, kEnd, Plaster({0.60F, 0.64F, 0.66F}));
  builder.AddFacingY(-kHalfWidth, kHalfWidth, kFloor, -1, kEnd, Smooth({0.36F, 0.40F, 0.44F}));
  builder.AddFacingY(-kHalfWidth, kHalfWidth, kCeiling, -1, kEnd, Smooth({0.74F, 0.75F, 0.76F}));
  builder.AddFacingZ(-kHalfWidth, kHalfWidth, kCeiling, kFloor, kEnd,
                     Plaster({0.5F, 0.52F, 0.55F}));
  AddDoors(-kHalfWidth, kFloor, &random, &builder);
  AddDoors(kHalfWidth, kFloor, &random, &builder);
  for (double z = 2.5; z < kEnd; z += 2.4) {  // lamps
    builder.AddFacingY(-0.6, 0.6, kCeiling + kLeafProud, z, z + 0.3, Plaster({0.95F, 0.95F, 0.9F}));
  }
  AddFramedOnZ({-0.5, 0.5}, {-0.7, 0.6}, kEnd, 0.08, Plaster({0.85F, 0.8F, 0.75F}), &builder);
  builder.SetLight({random.Uniform(-0.5, 0.5), kCeiling + 0.3, random.Uniform(3.0, 5.0)});
  builder.Turn(random.Uniform(4.0, 8.0) * kDegree, 0.0, 0.0);
  return builder.world();
}

World RoomWorld(std::uint64_t seed) {
  constexpr double kFloor = 1.5;
  constexpr double kCeiling = -1.1;
  constexpr double kHalfWidth = 2.2;
  constexpr double kBack = 4.5;
  constexpr double kTable = 0.75;  // height of its top
  Random random(seed);
  WorldBuilder builder;
  builder.AddFacingY(-3, 3, kFloor, -1, 5, Smooth({0.40F, 0.50F, 0.60F}));
  builder.AddFacingY(-3, 3, kCeiling, -1, 5, Smooth({0.75F, 0.75F, 0.75F}));
  builder.AddFacingX(-kHalfWidth, kCeiling, kFloor, -1, 5, Plaster({0.62F, 0.70F, 0.66F}));
  builder.AddFacingX(kHalfWidth, kCeiling, kFloor, -1, 5, Plaster({0.66F, 0.66F, 0.70F}));
  builder.AddFacingZ(-3, 3, kCeiling, kFloor, kBack, Plaster({0.60F, 0.64F, 0.68F}));
  for (const double x : {-kHalfWidth + kSkirtingProud, kHalfWidth - kSkirtingProud}) {
    builder.AddFacingX(x, kFloor - 0.1, kFloor, -1, 5, Smooth(kSkirting));
  }
  builder.AddFacingZ(-3, 3, kFloor - 0.1, kFloor, kBack - kSkirtingProud, Smooth(kSkirting));
  AddFramedOnX(-kHalfWidth, {-0.6, 0.5}, {2.6, 3.7}, 0.06, Plaster({0.85F, 0.8F, 0.75F}), &builder);
  AddFramedOnZ({0.2, 1.1}, {-0.6, 0.1}, kBack, 0.04, Rough({0.4F, 0.5F, 0.45F}), &builder);
  const double x = random.Uniform(-1.3, -1.0);
  AddTable(x, 2.4, kFloor, kTable, &builder);
  builder.AddBox({x + 0.2, kTable, 2.6}, {0.3, 0.25, 0.2}, Rough({0.30F, 0.35F, 0.70F}));
  builder.AddBox({x + 0.8, kTable, 2.7}, {0.2, 0.4, 0.2}, Rough({0.55F, 0.45F, 0.30F}));
  builder.AddBox({0.3, kFloor, random.Uniform(2.6, 3.2)}, {0.7, 0.9, 0.6},
                 Smooth({0.55F, 0.62F, 0.68F}));
  builder.SetLight({0.3, -0.3, 1.2});
  const double yaw = random.Uniform(18.0, 26.0);
  const double pitch = random.Uniform(1.0, 3.0);
  const double roll = random.Uniform(-3.0, -1.0);
  builder.Turn(yaw * kDegree, pitch * kDegree, roll * kDegree);
  return builder.world();
}

World FrontoParallelWorld(std::uint64_t seed) {
  constexpr int kBoxes = 7;
  Random random(seed);
  WorldBuilder builder;
  builder.AddFacingZ(-30, 30, -30, 30, 6.0, Rough({0.55F, 0.58F, 0.60F}));
  for (int i = 0; i < kBoxes; ++i) {
    const double z = random.Uniform(2.5, 5.0);
    const double x = z * (0.17 * (i - 3) + random.Uniform(-0.08, 0.02));
    const double y = z * random.Uniform(-0.3, 0.05);
    const cv::Vec3f albedo(0.3F + 0.05F * static_cast<float>(i), 0.5F,
                           0.6F - 0.05F * static_cast<float>(i));
    const double height = random.Uniform(0.4, 0.9);
    const double width = random.Uniform(0.4, 0.9);
    builder.AddFacingZ(x, x + width, y, y + height, z,
                       i % 2 == 0 ? Rough(albedo) : Plaster(albedo));
  }
  builder.SetLight({1.0, -3.0, 0.0});
  return builder.world();
}

World FenceWorld(std::uint64_t seed) {
  constexpr double kBarWidth = 0.015;
  constexpr double kBarDepth = 2.2;
  constexpr double kEdge = 2.6;        // depth of the walls where the picture ends
  constexpr double kHalfView = 0.625;  // x / z there
  Random random(seed);
  WorldBuilder builder;
  const Vector3d corner(random.Uniform(-0.4, 0.4), -10.0, random.Uniform(8.0, 9.0));
  for (const double side : {-1.0, 1.0}) {
    const Vector3d end(side * kHalfView * kEdge, corner.y(), kEdge);
    builder.Add(corner, 2.0 * (end - corner), {0, 20, 0}, Plaster({0.6F, 0.66F, 0.7F}));
  }
  for (double x = -4.0; x < 4.0; x += random.Uniform(0.11, 0.14)) {
    builder.AddFacingZ(x, x + kBarWidth, -10, 10, kBarDepth, Rough({0.5F, 0.55F, 0.58F}));
  }
  builder.SetLight({0.0, -1.0, 3.0});
  return builder.world();
}

World CurvedWorld(std::uint64_t seed) {
  constexpr double kFloor = 1.2;
  constexpr double kCeiling = -1.4;
  constexpr double kFar = 8.0;
  Random random(seed);
  WorldBuilder builder;
  builder.AddFacingY(-kFar, kFar, kFloor, -1, kFar, Smooth({0.36F, 0.40F, 0.44F}));
  builder.AddFacingY(-kFar, kFar, kCeiling, -1, kFar, Smooth({0.74F, 0.75F, 0.76F}));
  // The camera stands in a round hall.
  builder.AddColumn({random.Uniform(-0.3, 0.3), 0.0, 1.5}, 3.0, kCeiling, kFloor,
                    Plaster({0.60F, 0.66F, 0.70F}));
  builder.AddColumn({random.Uniform(-1.1, -0.9), 0.0, 3.0}, 0.35, kCeiling, kFloor,
                    Plaster({0.62F, 0.64F, 0.64F}));
  constexpr double kBall = 0.5;
  builder.AddSphere({random.Uniform(0.6, 0.9), kFloor - kBall, 2.9}, kBall,
                    Smooth({0.55F, 0.5F, 0.4F}));
  builder.SetLight({0.5, kCeiling + 0.3, 1.5});
  return builder.world();
}

}  // namespace stereo_sgmp
