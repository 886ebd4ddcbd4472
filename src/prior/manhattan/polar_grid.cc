#include "prior/manhattan/polar_grid.h"

#include <algorithm>
#include <cmath>
#include <cstddef>

namespace stereo_sgmp {
namespace {

constexpr double kDegreesPerRadian = 57.29577951308232;

}  // namespace

void PolarGrid::Smooth() {
  Cells smooth;
  for (int latitude = 0; latitude < kLatitudes; ++latitude) {
    for (int longitude = 0; longitude < kLongitudes; ++longitude) {
      double sum = 0.0;
      for (int i = -1; i <= 1; ++i) {
        for (int j = -1; j <= 1; ++j) sum += cells_[Index(latitude + i, longitude + j)];
      }
      smooth[Index(latitude, longitude)] = sum;
    }
  }
  cells_ = smooth;
}

std::size_t PolarGrid::CellOf(const Eigen::Vector3d& direction) {
  const Eigen::Vector3d front = direction.z() < 0.0 ? Eigen::Vector3d(-direction) : direction;
  const double latitude = std::atan2(std::hypot(front.x(), front.y()), front.z());
  const double longitude = std::atan2(front.y(), front.x());
  return Index(std::min(static_cast<int>(latitude * kDegreesPerRadian), kLatitudes - 1),
               static_cast<int>(std::floor(longitude * kDegreesPerRadian)));
}

// Both over the pole and over the equator, where the opposite direction takes over, the way goes
// on half a turn away.
std::size_t PolarGrid::Index(int latitude, int longitude) {
  if (latitude < 0 || latitude >= kLatitudes) {
    latitude = std::clamp(latitude, 0, kLatitudes - 1);
    longitude += kLongitudes / 2;
  }
  longitude = (longitude + 2 * kLongitudes) % kLongitudes;
  return static_cast<std::size_t>(latitude) * kLongitudes + static_cast<std::size_t>(longitude);
}

}  // namespace stereo_sgmp
