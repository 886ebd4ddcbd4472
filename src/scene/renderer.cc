#include "scene/renderer.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <vector>

#include <Eigen/Geometry>

namespace stereo_sgmp {
namespace {

constexpr int kRaysPerSide = 2;  // per pixel

// Finds the colour of what a ray of one view hits.
class Shader {
 public:
  Shader(const World& world, const PinholeView& view, const ValueNoise& noise)
      : world_(world), noise_(noise), projected_(Project(world, view)) {
    for (const Patch& patch : world.patches) {
      surfaces_.push_back({patch.edge_u.cross(patch.edge_v).normalized(), patch.edge_u.norm(),
                           patch.edge_v.norm()});
    }
  }

  cv::Vec3f ColorAt(double x, double y) const {
    const Hit hit = CastRay(projected_, x, y);
    if (hit.patch < 0) return {};
    const Material& material = world_.patches[static_cast<std::size_t>(hit.patch)].material;
    return material.albedo * (1.0F + material.contrast * Noise(hit)) * Light(hit);
  }

 private:
  struct Surface {
    Eigen::Vector3d normal;
    double length_u;  // metres
    double length_v;
  };

  float Noise(const Hit& hit) const {
    // Keeps the textures of different patches apart.
    constexpr double kApartS = 37.3;
    constexpr double kApartT = 71.9;
    const auto i = static_cast<std::size_t>(hit.patch);
    const Surface& surface = surfaces_[i];
    return noise_.At(hit.u * surface.length_u + kApartS * hit.patch,
                     hit.v * surface.length_v + kApartT * hit.patch,
                     world_.patches[i].material.octaves, Footprint(hit));
  }

  // Metres of surface from one ray to the next, along its most foreshortened edge.
  float Footprint(const Hit& hit) const {
    const auto i = static_cast<std::size_t>(hit.patch);
    const ProjectedPatch& p = projected_[i];
    const auto change = [&](const ProjectedPatch::Linear& numerator, double ratio) {
      return (std::abs(numerator.dx - ratio * p.w.dx) + std::abs(numerator.dy - ratio * p.w.dy)) /
             (hit.w * kRaysPerSide);
    };
    return static_cast<float>(std::max(change(p.uw, hit.u) * surfaces_[i].length_u,
                                       change(p.vw, hit.v) * surfaces_[i].length_v));
  }

  // Lambert's law for the one light, and the ambient part.
  float Light(const Hit& hit) const {
    const auto i = static_cast<std::size_t>(hit.patch);
    const Patch& patch = world_.patches[i];
    const Eigen::Vector3d to_light =
        world_.light - (patch.origin + hit.u * patch.edge_u + hit.v * patch.edge_v);
    const double cosine = std::abs(surfaces_[i].normal.dot(to_light)) / to_light.norm();
    return world_.ambient + (1.0F - world_.ambient) * static_cast<float>(cosine);
  }

  const World& world_;
  const ValueNoise& noise_;
  std::vector<ProjectedPatch> projected_;
  std::vector<Surface> surfaces_;
};

cv::Vec3f PixelColor(const Shader& shader, const RowShift& shift, int x, int y) {
  cv::Vec3f sum;
  for (int j = 0; j < kRaysPerSide; ++j) {
    const double row = y + (j + 0.5) / kRaysPerSide - 0.5;
    for (int i = 0; i < kRaysPerSide; ++i) {
      const double column = x + (i + 0.5) / kRaysPerSide - 0.5;
      sum += shader.ColorAt(column, (row - shift.offset) / shift.scale);
    }
  }
  return sum * (1.0F / (kRaysPerSide * kRaysPerSide));
}

}  // namespace

PinholeView LeftView(const StereoCamera& camera) {
  return {camera.focal_length, camera.cx, camera.cy, Eigen::Vector3d::Zero()};
}

PinholeView RightView(const StereoCamera& camera) {
  return {camera.focal_length, camera.cx + camera.doffs, camera.cy,
          Eigen::Vector3d(camera.baseline, 0.0, 0.0)};
}

cv::Mat_<cv::Vec3f> RenderView(const World& world, const PinholeView& view, cv::Size size,
                               const RowShift& shift, const ValueNoise& noise, ThreadPool* pool) {
  const Shader shader(world, view, noise);
  cv::Mat_<cv::Vec3f> picture(size);
  pool->ForRanges(size.height, [&](int begin, int end) {
    for (int y = begin; y < end; ++y) {
      for (int x = 0; x < size.width; ++x) picture(y, x) = PixelColor(shader, shift, x, y);
    }
  });
  return picture;
}

void RenderGroundTruth(const World& world, const StereoCamera& camera, const RowShift& right_shift,
                       ThreadPool* pool, cv::Size size, cv::Mat* disparity, cv::Mat* mask) {
  constexpr std::uint8_t kNothing = 0;
  constexpr std::uint8_t kOccluded = 128;
  constexpr std::uint8_t kVisible = 255;
  constexpr double kRounding = 1e-9;
  const std::vector<ProjectedPatch> left = Project(world, LeftView(camera));
  const std::vector<ProjectedPatch> right = Project(world, RightView(camera));
  disparity->create(size, CV_32F);
  mask->create(size, CV_8U);
  const auto seen_from_right = [&](const Hit& hit, double d, int x, int y) {
    const double right_x = x - d;
    const double right_y = right_shift.scale * y + right_shift.offset;
    const bool inside =
        right_x >= 0.0 && right_x <= size.width - 1 && right_y >= 0.0 && right_y <= size.height - 1;
    return inside && CastRay(right, right_x, y).w <= hit.w * (1.0 + kRounding);
  };
  pool->ForRanges(size.height, [&](int begin, int end) {
    for (int y = begin; y < end; ++y) {
      for (int x = 0; x < size.width; ++x) {
        const Hit hit = CastRay(left, x, y);
        const double d = camera.focal_length * camera.baseline * hit.w - camera.doffs;
        const bool found = hit.patch >= 0;
        disparity->at<float>(y, x) =
            found ? static_cast<float>(d) : std::numeric_limits<float>::infinity();
        mask->at<std::uint8_t>(y, x) =
            !found ? kNothing : (seen_from_right(hit, d, x, y) ? kVisible : kOccluded);
      }
    }
  });
}

}  // namespace stereo_sgmp
