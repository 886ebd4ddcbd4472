// Planes over the image: none, one or several at each pixel.
#ifndef STEREO_SGMP_PRIOR_PLANE_SETS_H_
#define STEREO_SGMP_PRIOR_PLANE_SETS_H_

#include <array>
#include <cstdint>
#include <limits>
#include <vector>

#include <opencv2/core.hpp>

#include "stereo_sgmp/disparity_plane.h"

namespace stereo_sgmp {

// The planes that hold at a pixel, as indices into a list of planes; those with the largest
// support first.
struct PlaneSet {
  // Planes that are found for one pixel, and the copies of each that a prior may follow.
  static constexpr int kMaxFound = 8;
  static constexpr int kPhases = 3;
  static constexpr int kMaxPlanes = kMaxFound * kPhases;
  // Planes of a whole image: 16 bits name them and their copies.
  static constexpr int kMaxListed = std::numeric_limits<std::int16_t>::max() / kPhases;

  std::uint8_t count = 0;
  std::array<std::int16_t, kMaxPlanes> planes{};
};

// Few distinct sets occur in an image, so pixels carry the number of their set.
struct PlaneSets {
  std::vector<PlaneSet> sets;  // sets[0] is the empty set
  cv::Mat ids;                 // CV_16U, index into `sets`, at any resolution
};

}  // namespace stereo_sgmp

#endif  // STEREO_SGMP_PRIOR_PLANE_SETS_H_
