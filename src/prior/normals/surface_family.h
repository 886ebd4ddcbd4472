// All disparity surfaces that normals allow: their depth is unknown (paper, Sec. 3.4).
#ifndef STEREO_SGMP_PRIOR_NORMALS_SURFACE_FAMILY_H_
#define STEREO_SGMP_PRIOR_NORMALS_SURFACE_FAMILY_H_

#include <vector>

#include <opencv2/core.hpp>

#include "prior/normals/normal_integration.h"

namespace stereo_sgmp {

// The surfaces S_k(p) = s_k e(p) - doffs in pixels, with e = exp(delta) of geometric mean 1 over
// each component, so that s_k is the mean d + doffs of surface k. They rise with k at each pixel.
struct SurfaceFamily {
  static constexpr int kMaxSurfaces = 64;

  std::vector<float> scales;  // s_k > 0, rising, at most kMaxSurfaces
  cv::Mat_<float> shape;      // e > 0; 1 where unknown
  cv::Mat_<int> component;    // as IntegratedNormals
  float doffs = 0.0F;         // pixels

  float At(float scale, float e) const { return scale * e - doffs; }
};

// Surfaces over the whole search range at every pixel, at distances of 16 px or, where that is
// more, 0.3 times d + doffs: slopes are in proportion to d + doffs, so that the nearest surface has
// about the right one. With 8 px and 0.2 the share of wrong disparities of generated and real
// scenes changed by up to 3 %, up and down, and aggregation took half as long again.
// Throws std::invalid_argument where no disparity of the range has a positive d + doffs.
SurfaceFamily SurfacesAtAllDepths(const IntegratedNormals& normals, double doffs, int min_disparity,
                                  int disparities);

// The one surface whose mean disparity is `disparity`. Throws std::invalid_argument where
// disparity + doffs isn't positive.
SurfaceFamily SurfaceAtDepth(const IntegratedNormals& normals, double doffs, double disparity);

}  // namespace stereo_sgmp

#endif  // STEREO_SGMP_PRIOR_NORMALS_SURFACE_FAMILY_H_
