#ifndef STEREO_SGMP_PRIOR_LABEL_OUTLINES_H_
#define STEREO_SGMP_PRIOR_LABEL_OUTLINES_H_

#include <cstddef>
#include <vector>

#include <opencv2/core.hpp>

namespace stereo_sgmp {

// For each label below `count`, the first and last pixel of it in each row, which span the same
// convex hull as all of its pixels. `labels`: CV_16S, negative for none. Reuses the storage.
void CollectLabelOutlines(const cv::Mat& labels, std::size_t count,
                          std::vector<std::vector<cv::Point>>* outlines);

}  // namespace stereo_sgmp

#endif  // STEREO_SGMP_PRIOR_LABEL_OUTLINES_H_
