#include "prior/convex_hulls.h"

#include <cstddef>

#include <opencv2/imgproc.hpp>

namespace stereo_sgmp {

void ConvexHulls::Build(const PlaneMap& map) {
  painter_.Start(map.labels.size());
  inside_.create(map.labels.size(), CV_8UC1);
  CollectOutlines(map);
  // Planes come in falling order of area, so each set lists the largest first.
  for (std::size_t i = 0; i < map.planes.size(); ++i) Paint(static_cast<std::int16_t>(i));
}

// The first and last pixel of a label in a row span the same hull as all of them.
void ConvexHulls::CollectOutlines(const PlaneMap& map) {
  const std::size_t planes = map.planes.size();
  if (outlines_.size() < planes) outlines_.resize(planes);
  for (std::vector<cv::Point>& outline : outlines_) outline.clear();
  for (int y = 0; y < map.labels.rows; ++y) {
    const std::int16_t* labels = map.labels.ptr<std::int16_t>(y);
    for (int x = 0; x < map.labels.cols; ++x) {
      if (labels[x] < 0) continue;
      std::vector<cv::Point>& outline = outlines_[static_cast<std::size_t>(labels[x])];
      const std::size_t n = outline.size();
      const bool extends_row = n >= 2 && outline[n - 1].y == y && outline[n - 2].y == y;
      if (extends_row) {
        outline.back().x = x;
      } else {
        outline.emplace_back(x, y);
      }
    }
  }
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
