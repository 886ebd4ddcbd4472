// Plane hypotheses that overlap: SGM-EPv of the paper.
#ifndef STEREO_SGMP_PRIOR_CONVEX_HULLS_H_
#define STEREO_SGMP_PRIOR_CONVEX_HULLS_H_

#include <cstdint>
#include <vector>

#include <opencv2/core.hpp>

#include "prior/plane_hypotheses.h"
#include "prior/plane_set_painter.h"
#include "prior/plane_sets.h"

namespace stereo_sgmp {

// Bounds every plane by the convex hull of its label pixels. Pixels inside several hulls hold
// several planes, at most PlaneSet::kMaxFound, those of the largest area. Keeps its buffers.
class ConvexHulls {
 public:
  void Build(const PlaneMap& map);

  // Gives the pixels outside all hulls the plane of `labels` (CV_16S, -1 for none).
  void FillEmpty(const cv::Mat& labels) { painter_.FillEmpty(labels); }

  // At the resolution of the labels.
  const PlaneSets& sets() const { return painter_.sets(); }

 private:
  void Paint(std::int16_t plane);

  std::vector<std::vector<cv::Point>> outlines_;  // ends of each row of a label, per plane
  std::vector<cv::Point> hull_;
  cv::Mat inside_;
  PlaneSetPainter painter_;
};

}  // namespace stereo_sgmp

#endif  // STEREO_SGMP_PRIOR_CONVEX_HULLS_H_
