#ifndef STEREO_SGMP_PRIOR_NEAREST_PLANES_H_
#define STEREO_SGMP_PRIOR_NEAREST_PLANES_H_

#include <vector>

#include <opencv2/core.hpp>

#include "common/thread_pool.h"
#include "prior/plane_sets.h"
#include "stereo_sgmp/disparity_plane.h"

namespace stereo_sgmp {

// Of the planes that hold at a pixel the one nearest to its disparity. `disparity` is CV_32F of
// the size of sets.ids, `planes` are in its pixels. `labels` becomes CV_16S: an index into
// `planes`, -1 where none holds.
// `threads` may be null.
void LabelNearestPlanes(const PlaneSets& sets, const std::vector<DisparityPlane>& planes,
                        const cv::Mat& disparity, cv::Mat* labels, ThreadPool* threads = nullptr);

}  // namespace stereo_sgmp

#endif  // STEREO_SGMP_PRIOR_NEAREST_PLANES_H_
