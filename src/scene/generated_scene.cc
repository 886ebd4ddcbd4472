#include "scene/generated_scene.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <stdexcept>
#include <utility>

#include "common/thread_pool.h"
#include "scene/ground_truth.h"
#include "scene/layouts.h"
#include "scene/renderer.h"
#include "scene/sensor.h"
#include "scene/world.h"

namespace stereo_sgmp {
namespace {

constexpr std::array<std::pair<SceneKind, const char*>, 6> kNames{
    {{SceneKind::kCorridor, "corridor"},
     {SceneKind::kSlantedPlane, "slanted_plane"},
     {SceneKind::kRoom, "room"},
     {SceneKind::kFrontoParallel, "fronto_parallel"},
     {SceneKind::kFence, "fence"},
     {SceneKind::kCurved, "curved"}}};

// A wide-angle camera without baseline.
StereoCamera CameraFor(cv::Size size) {
  StereoCamera camera;
  camera.focal_length = 0.8 * size.width;
  camera.cx = (size.width - 1) / 2.0;
  camera.cy = (size.height - 1) / 2.0;
  return camera;
}

void CheckArguments(cv::Size size, int num_disparities) {
  constexpr int kFewest = 8;
  if (size.height < 1 || num_disparities < kFewest || num_disparities > size.width / 2) {
    throw std::invalid_argument(
        "A scene of " + std::to_string(size.width) + " x " + std::to_string(size.height) +
        " pixels and " + std::to_string(num_disparities) +
        " disparities can't be made; at least 8 disparities and at most half the width are "
        "expected.");
  }
}

// Largest 1 / z of what the camera sees.
double NearestInverseDepth(const World& world, const StereoCamera& camera, cv::Size size) {
  constexpr int kSteps = 64;
  const WorldView view(world, LeftView(camera));
  double nearest = 0.0;
  for (int j = 0; j <= kSteps; ++j) {
    for (int i = 0; i <= kSteps; ++i) {
      const double x = (size.width - 1.0) * i / kSteps;
      const double y = (size.height - 1.0) * j / kSteps;
      nearest = std::max(nearest, view.Cast(x, y).point.w);
    }
  }
  return nearest;
}

World WorldOf(SceneKind kind, std::uint64_t seed) {
  switch (kind) {
    case SceneKind::kRoom:
      return RoomWorld(seed);
    case SceneKind::kFrontoParallel:
      return FrontoParallelWorld(seed);
    case SceneKind::kFence:
      return FenceWorld(seed);
    case SceneKind::kCurved:
      return CurvedWorld(seed);
    case SceneKind::kCorridor:
      return CorridorWorld(seed);
    case SceneKind::kSlantedPlane:
      break;  // made by MakeSlantedPlane
  }
  throw std::logic_error("There is no world for this kind of scene.");
}

// The right camera's sensor, from the left one's.
Sensor RightSensor(Sensor sensor, const SceneQuality& quality) {
  sensor.vignetting = quality.right_vignetting;
  sensor.gain = quality.gain;
  sensor.offset = quality.offset;
  ++sensor.seed;
  return sensor;
}

GeneratedScene Photograph(World world, const StereoCamera& camera, cv::Size size,
                          int num_disparities, const SceneQuality& quality, std::uint64_t seed) {
  const auto contrast = static_cast<float>(quality.contrast);
  for (Patch& patch : world.patches) patch.material.contrast *= contrast;
  for (RoundSurface& surface : world.round_surfaces) surface.material.contrast *= contrast;
  ThreadPool pool(0);
  const ValueNoise noise(seed);
  const RowShift shift{quality.vertical_scale, quality.vertical_offset};
  const Sensor sensor{camera.cx, camera.cy, quality.vignetting, quality.blur,
                      1.0,       0.0,       quality.noise,      2 * seed};
  GeneratedScene scene;
  scene.camera = camera;
  scene.num_disparities = num_disparities;
  scene.world_rotation = world.rotation;
  scene.left = Expose(sensor, RenderView(world, LeftView(camera), size, {}, noise, &pool));
  scene.right = Expose(RightSensor(sensor, quality),
                       RenderView(world, RightView(camera), size, shift, noise, &pool));
  GroundTruth truth = RenderGroundTruth(world, camera, shift, size, &pool);
  scene.disparity = truth.disparity;
  scene.mask = truth.mask;
  scene.normals = truth.normals;
  scene.labels = truth.labels;
  scene.planes = std::move(truth.planes);
  return scene;
}

// Slants of the plane that stands for all: a wall that a robot passes, leaning a little.
constexpr double kDefaultSlantX = 0.25;  // share of num_disparities over the image
constexpr double kDefaultSlantY = 0.15;

}  // namespace

SceneKind SceneKindFromName(const std::string& name) {
  std::string known;
  for (const auto& [kind, kind_name] : kNames) {
    if (name == kind_name) return kind;
    known += (known.empty() ? "" : ", ") + std::string(kind_name);
  }
  throw std::invalid_argument("There is no scene \"" + name + "\"; the scenes are " + known + ".");
}

GeneratedScene MakeScene(SceneKind kind, cv::Size size, int num_disparities,
                         const SceneQuality& quality, std::uint64_t seed) {
  CheckArguments(size, num_disparities);
  if (kind == SceneKind::kSlantedPlane) {
    return MakeSlantedPlane(size, num_disparities, kDefaultSlantX * num_disparities / size.width,
                            kDefaultSlantY * num_disparities / size.height, quality, seed);
  }
  constexpr double kRangeUsed = 0.9;
  const World world = WorldOf(kind, seed);
  StereoCamera camera = CameraFor(size);
  camera.baseline = kRangeUsed * (num_disparities - 1) /
                    (camera.focal_length * NearestInverseDepth(world, camera, size));
  return Photograph(world, camera, size, num_disparities, quality, seed);
}

GeneratedScene MakeSlantedPlane(cv::Size size, int num_disparities, double slant_x, double slant_y,
                                const SceneQuality& quality, std::uint64_t seed) {
  CheckArguments(size, num_disparities);
  constexpr double kDepth = 3.0;   // metres, in the middle
  constexpr double kExtent = 1e3;  // metres: more than any camera sees
  const double middle = num_disparities / 2.0;
  const double reach =
      (std::abs(slant_x) * (size.width - 1) + std::abs(slant_y) * (size.height - 1)) / 2.0;
  if (!(reach < middle - 1.0)) {
    throw std::invalid_argument("The slants " + std::to_string(slant_x) + " and " +
                                std::to_string(slant_y) + " leave the range of " +
                                std::to_string(num_disparities) + " disparities.");
  }
  StereoCamera camera = CameraFor(size);
  camera.baseline = middle * kDepth / camera.focal_length;
  // On the plane 1 / z = (1 + k.x x + k.y y) / kDepth with x and y in units of the depth.
  const Eigen::Vector2d k = Eigen::Vector2d(slant_x, slant_y) * camera.focal_length / middle;
  const Eigen::Vector3d along_u = Eigen::Vector3d(1.0, 0.0, -k.x()).normalized();
  const Eigen::Vector3d along_v = Eigen::Vector3d(0.0, 1.0, -k.y()).normalized();
  World world;
  Patch plane;
  plane.origin = Eigen::Vector3d(0.0, 0.0, kDepth) - kExtent * (along_u + along_v);
  plane.edge_u = 2.0 * kExtent * along_u;
  plane.edge_v = 2.0 * kExtent * along_v;
  plane.material.contrast = 0.25F;
  plane.material.octaves = {8, 4.0F, 0.85F};
  world.patches.push_back(plane);
  return Photograph(world, camera, size, num_disparities, quality, seed);
}

}  // namespace stereo_sgmp
