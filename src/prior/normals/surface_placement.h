// Where the surfaces integrated from normals lie, as far as a coarse disparity map shows it.
#ifndef STEREO_SGMP_PRIOR_NORMALS_SURFACE_PLACEMENT_H_
#define STEREO_SGMP_PRIOR_NORMALS_SURFACE_PLACEMENT_H_

#include <opencv2/core.hpp>

#include "common/thread_pool.h"
#include "prior/normals/normal_integration.h"
#include "prior/plane_hypotheses.h"

namespace stereo_sgmp {

// The disparity surface (CV_32F, pixels; nan where unknown) with the shape of the normals, each
// component at the scale that the confident coarse disparities on it and on what continues it in
// the nearest cells agree on. Surfaces one behind the other whose normals are the same are of one
// component: it has up to three scales, and each of its pixels that which the coarse disparities
// around it agree with best. `doffs` in pixels, as of the camera.
cv::Mat_<float> PlaceSurfaces(const IntegratedNormals& normals, const CoarseDisparity& coarse,
                              double doffs, ThreadPool* pool);

}  // namespace stereo_sgmp

#endif  // STEREO_SGMP_PRIOR_NORMALS_SURFACE_PLACEMENT_H_
