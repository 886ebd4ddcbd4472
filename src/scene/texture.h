#ifndef STEREO_SGMP_SCENE_TEXTURE_H_
#define STEREO_SGMP_SCENE_TEXTURE_H_

#include <cstdint>
#include <vector>

#include <opencv2/core.hpp>

namespace stereo_sgmp {

// Smooth random values over the plane: octaves of value noise, each of twice the frequency and
// `persistence` times the amplitude of the one before.
class ValueNoise {
 public:
  explicit ValueNoise(std::uint64_t seed);

  struct Octaves {
    int count = 4;
    float frequency = 1.0F;  // lattice cells per unit length of the first octave
    float persistence = 0.7F;
  };

  // The value at (s, t), about -1..1 with mean 0, as seen through a pixel that covers
  // `footprint` units of length: octaves finer than it fade out, which keeps pictures of far
  // surfaces free of aliasing.
  float At(double s, double t, const Octaves& octaves, float footprint) const;

 private:
  float Lattice(double s, double t) const;

  std::vector<float> values_;
};

// What a surface looks like: albedo * (1 + contrast * noise).
struct Material {
  cv::Vec3f albedo{0.5F, 0.5F, 0.5F};  // blue, green, red, 0..1
  float contrast = 0.2F;
  ValueNoise::Octaves octaves;  // lengths in metres
};

}  // namespace stereo_sgmp

#endif  // STEREO_SGMP_SCENE_TEXTURE_H_
