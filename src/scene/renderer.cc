#include "scene/renderer.h"

#include <cmath>

namespace stereo_sgmp {
namespace {

constexpr int kRaysPerSide = 2;  // per pixel

// Finds the colour of what a ray of one view hits.
class Shader {
 public:
  Shader(const World& world, const PinholeView& view, const ValueNoise& noise)
      : world_(world), noise_(noise), world_view_(world, view) {}

  cv::Vec3f ColorAt(double x, double y) const {
    const Hit hit = world_view_.Cast(x, y);
    if (hit.surface < 0) return {};
    const Material& material = world_.MaterialOf(hit.surface);
    const auto footprint = static_cast<float>(world_view_.Footprint(hit, x, y) / kRaysPerSide);
    return material.albedo * (1.0F + material.contrast * Noise(hit, material, footprint)) *
           Light(hit, x, y);
  }

 private:
  float Noise(const Hit& hit, const Material& material, float footprint) const {
    // Keeps the textures of different surfaces apart.
    constexpr double kApartS = 37.3;
    constexpr double kApartT = 71.9;
    return noise_.At(hit.point.s + kApartS * hit.surface, hit.point.t + kApartT * hit.surface,
                     material.octaves, footprint);
  }

  // Lambert's law for the one light, and the ambient part.
  float Light(const Hit& hit, double x, double y) const {
    const Eigen::Vector3d to_light = world_.light - world_view_.PointAt(hit, x, y);
    const double cosine = std::abs(world_view_.NormalAt(hit, x, y).dot(to_light)) / to_light.norm();
    return world_.ambient + (1.0F - world_.ambient) * static_cast<float>(cosine);
  }

  const World& world_;
  const ValueNoise& noise_;
  WorldView world_view_;
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

}  // namespace stereo_sgmp
