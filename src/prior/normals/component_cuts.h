// Components of integrated normals end where surfaces of two depths meet at an edge of the image.
#ifndef STEREO_SGMP_PRIOR_NORMALS_COMPONENT_CUTS_H_
#define STEREO_SGMP_PRIOR_NORMALS_COMPONENT_CUTS_H_

#include <opencv2/core.hpp>

namespace stereo_sgmp {

// The components with numbers of their own, of which IntegratedNormals::CellOf holds, cut between
// pixels of different labels. Two labels of a component stay together where the image changes
// hardly more along their border than over the component: errors of the coarse disparities, other
// than surfaces, end anywhere. `label`: the index of each pixel's scale in its component, or
// -1; `edges` as of ImageEdges; both of the size of `component`.
cv::Mat_<int> CutComponents(const cv::Mat_<int>& component, const cv::Mat_<schar>& label,
                            const cv::Mat_<uchar>& edges);

}  // namespace stereo_sgmp

#endif  // STEREO_SGMP_PRIOR_NORMALS_COMPONENT_CUTS_H_
