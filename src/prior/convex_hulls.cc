#include "prior/convex_hulls.h"

#include <cstddef>

#include <opencv2/imgproc.hpp>

#include "prior/label_outlines.h"

namespace stereo_sgmp {

void ConvexHulls::Build(const PlaneMap& map) {
  painter_.Start(map.labels.size());
  inside_.create(map.labels.size(), CV_8UC1);
  CollectLabelOutlines(map.labels, map.planes.size(), &outlines_);
  // Planes come in falling order of area, so each set lists the largest first.
  for (std::size_t i = 0; i < map.planes.size(); ++i) Paint(static_cast<std::int16_t>(i));
}

void ConvexHulls::Paint(std::int16_t plane) {
  const std::vector<cv::Point>& outline = outlines_[static_cast<std::size_t>(plane)];
  if (outline.empty()) return;
  cv::convexHull(outline, hull_);
  const cv::Rect box = cv::boundingRect(hull_);
  cv::Mat inside = inside_(box);
  inside.setTo(0);
  for (cv::Point& corner : hull_) corner -= box.tl();
  cv::fillConvexPoly(inside, hull_, cv::Scalar(255));
  painter_.Paint(plane, inside, box.tl());
}

}  // namespace stereo_sgmp
