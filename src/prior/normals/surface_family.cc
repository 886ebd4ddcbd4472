#include "prior/normals/surface_family.h"

#include <algorithm>
#include <sstream>
#include <stdexcept>

namespace stereo_sgmp {
namespace {

// Distance of neighbouring surfaces, pixels and as a part of d + doffs.
constexpr double kSmallestDistance = 16.0;
constexpr double kRelativeDistance = 0.3;

SurfaceFamily WithoutScales(const IntegratedNormals& normals, double doffs) {
  SurfaceFamily family;
  cv::exp(normals.log_disparity, family.shape);
  normals.component.copyTo(family.component);
  family.doffs = static_cast<float>(doffs);
  return family;
}

}  // namespace

SurfaceFamily SurfacesAtAllDepths(const IntegratedNormals& normals, double doffs, int min_disparity,
                                  int disparities) {
  const double nearest = min_disparity + disparities - 1 + doffs;
  if (nearest <= 0.0) {
    std::ostringstream message;
    message << "The search range ends at disparity " << min_disparity + disparities - 1
            << ", but with doffs " << doffs << " of the camera only disparities above " << -doffs
            << " lie in front of it; raise min_disparity or num_disparities.";
    throw std::invalid_argument(message.str());
  }
  SurfaceFamily family = WithoutScales(normals, doffs);
  double smallest = 1.0;
  double largest = 1.0;
  cv::minMaxLoc(family.shape, &smallest, &largest);
  double scale = std::max((min_disparity + doffs) / largest, 0.5 * kSmallestDistance);
  family.scales.push_back(static_cast<float>(scale));
  while (scale * smallest < nearest && family.scales.size() < SurfaceFamily::kMaxSurfaces) {
    scale += std::max(kSmallestDistance, kRelativeDistance * scale);
    family.scales.push_back(static_cast<float>(scale));
  }
  return family;
}

SurfaceFamily SurfaceAtDepth(const IntegratedNormals& normals, double doffs, double disparity) {
  if (!(disparity + doffs > 0.0)) {
    std::ostringstream message;
    message << "The surface from normals is to lie at disparity " << disparity
            << ", but with doffs " << doffs << " of the camera only disparities above " << -doffs
            << " lie in front of it; set another.";
    throw std::invalid_argument(message.str());
  }
  SurfaceFamily family = WithoutScales(normals, doffs);
  family.scales.push_back(static_cast<float>(disparity + doffs));
  return family;
}

}  // namespace stereo_sgmp
