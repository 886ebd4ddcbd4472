#include "scene/texture.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <random>

namespace stereo_sgmp {
namespace {

// Side of the table of lattice values, a power of two; the noise repeats after as many cells.
constexpr std::uint32_t kSide = 256;

float Smooth(float t) { return t * t * (3.0F - 2.0F * t); }

std::size_t Index(std::uint32_t column, std::uint32_t row) {
  return static_cast<std::size_t>(row % kSide) * kSide + column % kSide;
}

}  // namespace

ValueNoise::ValueNoise(std::uint64_t seed) : values_(kSide * kSide) {
  // The raw bits: the standard's distributions differ between libraries.
  std::mt19937 bits(static_cast<std::uint32_t>(seed ^ (seed >> 32)));
  for (float& value : values_) {
    value = static_cast<float>(bits() >> 8) * (2.0F / static_cast<float>(1U << 24)) - 1.0F;
  }
}

float ValueNoise::At(double s, double t, const Octaves& octaves, float footprint) const {
  float frequency = octaves.frequency;
  float amplitude = 1.0F;
  float sum = 0.0F;
  for (int i = 0; i < octaves.count; ++i) {
    // Full weight up to half a cell per pixel, none from one cell per pixel on.
    const float weight = std::min(2.0F - 2.0F * frequency * footprint, 1.0F);
    if (weight <= 0.0F) break;
    sum += weight * amplitude * Lattice(s * frequency, t * frequency);
    frequency *= 2.0F;
    amplitude *= octaves.persistence;
  }
  return sum;
}

float ValueNoise::Lattice(double s, double t) const {
  const double column = std::floor(s);
  const double row = std::floor(t);
  const auto c = static_cast<std::uint32_t>(static_cast<std::int32_t>(column));
  const auto r = static_cast<std::uint32_t>(static_cast<std::int32_t>(row));
  const float u = Smooth(static_cast<float>(s - column));
  const float v = Smooth(static_cast<float>(t - row));
  const float top = values_[Index(c, r)] * (1.0F - u) + values_[Index(c + 1, r)] * u;
  const float bottom = values_[Index(c, r + 1)] * (1.0F - u) + values_[Index(c + 1, r + 1)] * u;
  return top * (1.0F - v) + bottom * v;
}

}  // namespace stereo_sgmp
