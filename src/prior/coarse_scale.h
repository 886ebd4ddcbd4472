// How a coarse image and its disparities map to full resolution.
#ifndef STEREO_SGMP_PRIOR_COARSE_SCALE_H_
#define STEREO_SGMP_PRIOR_COARSE_SCALE_H_

#include <opencv2/core.hpp>

#include "stereo_sgmp/disparity_plane.h"

namespace stereo_sgmp {

// Full size over coarse size, apart for x and y because coarse sizes are rounded. Disparities
// are lengths along x and scale with x.
struct CoarseScale {
  double x = 1.0;
  double y = 1.0;

  static CoarseScale Between(cv::Size full, cv::Size coarse) {
    return {static_cast<double>(full.width) / coarse.width,
            static_cast<double>(full.height) / coarse.height};
  }

  // The same surface in full-resolution pixels; pixel centres are at integer coordinates:
  // d_full(u, v) = x * d_coarse((u + 1/2) / x - 1/2, (v + 1/2) / y - 1/2).
  DisparityPlane ToFull(const DisparityPlane& coarse) const {
    const double offset = coarse.a * (1.0 - x) / 2.0 + coarse.b * (1.0 - y) * x / y / 2.0;
    return {coarse.a, coarse.b * x / y, x * coarse.c + offset};
  }

  DisparityPlane ToCoarse(const DisparityPlane& full) const {
    const DisparityPlane sloped{full.a, full.b * y / x, 0.0};
    return {sloped.a, sloped.b, (full.c - ToFull(sloped).c) / x};
  }
};

}  // namespace stereo_sgmp

#endif  // STEREO_SGMP_PRIOR_COARSE_SCALE_H_
