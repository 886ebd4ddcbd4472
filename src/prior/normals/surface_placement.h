// Where the surfaces integrated from normals lie and end, as far as a coarse disparity map and the
// image show it.
#ifndef STEREO_SGMP_PRIOR_NORMALS_SURFACE_PLACEMENT_H_
#define STEREO_SGMP_PRIOR_NORMALS_SURFACE_PLACEMENT_H_

#include <opencv2/core.hpp>

#include "common/thread_pool.h"
#include "prior/normals/normal_integration.h"
#include "prior/plane_hypotheses.h"

namespace stereo_sgmp {

struct PlacedSurfaces {
  cv::Mat_<float> disparity;  // with the shape of the normals, pixels; nan where unknown
  // The components of the normals, cut where they step in depth; with numbers of their own, of
  // which IntegratedNormals::CellOf holds.
  cv::Mat_<int> component;
};

// Surfaces one behind the other whose normals are the same are of one component. It has the scales
// that the confident coarse disparities on it and on what continues it in the nearest cells agree
// on. Where the coarse disparities around a pixel leave no doubt they choose among these; between,
// surfaces spread over `image` and meet at its edges. `image`: the left one, CV_8U, of the size of
// the normals. `doffs` in pixels, as of the camera.
PlacedSurfaces PlaceSurfaces(const IntegratedNormals& normals, const CoarseDisparity& coarse,
                             const cv::Mat& image, double doffs, ThreadPool* pool);

}  // namespace stereo_sgmp

#endif  // STEREO_SGMP_PRIOR_NORMALS_SURFACE_PLACEMENT_H_
