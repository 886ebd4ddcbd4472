#include "stereo_sgmp/prior_polygons.h"

#include <stdexcept>
#include <string>
#include <utility>

#include <opencv2/imgproc.hpp>

#include "prior/label_outlines.h"

namespace stereo_sgmp {
namespace {

using Polygon = std::vector<cv::Point2d>;

// The hull of coarse pixels, borders included, in pixels of the full image, whose centres are
// whole.
Polygon Hull(const std::vector<cv::Point>& pixels, double scale_x, double scale_y) {
  std::vector<cv::Point> corners;
  for (const cv::Point& pixel : pixels) {
    for (const int dy : {0, 1}) {
      for (const int dx : {0, 1}) corners.emplace_back(pixel.x + dx, pixel.y + dy);
    }
  }
  std::vector<cv::Point> hull;
  cv::convexHull(corners, hull);
  Polygon polygon;
  for (const cv::Point& corner : hull) {
    polygon.emplace_back(corner.x * scale_x - 0.5, corner.y * scale_y - 0.5);
  }
  return polygon;
}

// The part of a convex polygon where the plane's disparity is at least `least`.
Polygon CutBelow(const Polygon& polygon, const DisparityPlane& plane, double least) {
  Polygon kept;
  for (std::size_t i = 0; i < polygon.size(); ++i) {
    const cv::Point2d& from = polygon[i];
    const cv::Point2d& to = polygon[(i + 1) % polygon.size()];
    const double above_from = plane.At(from.x, from.y) - least;
    const double above_to = plane.At(to.x, to.y) - least;
    if (above_from >= 0.0) kept.push_back(from);
    if ((above_from >= 0.0) != (above_to >= 0.0)) {
      kept.push_back(from + (to - from) * (above_from / (above_from - above_to)));
    }
  }
  return kept;
}

}  // namespace

std::vector<PriorPolygon> PriorPolygons(const PlanePriors& priors, cv::Size image_size,
                                        const StereoCamera& camera, double max_depth) {
  camera.Check();
  if (!(max_depth > 0.0)) {
    throw std::invalid_argument("max_depth is " + std::to_string(max_depth) +
                                "; expected a positive depth");
  }
  std::vector<PriorPolygon> polygons;
  if (priors.labels.empty()) return polygons;
  const double scale_x = static_cast<double>(image_size.width) / priors.labels.cols;
  const double scale_y = static_cast<double>(image_size.height) / priors.labels.rows;
  const double least = camera.DisparityOf(max_depth);
  std::vector<std::vector<cv::Point>> outlines;
  CollectLabelOutlines(priors.labels, priors.planes.size(), &outlines);
  for (std::size_t i = 0; i < outlines.size(); ++i) {
    if (outlines[i].empty()) continue;
    const DisparityPlane& plane = priors.planes[i].plane;
    const Polygon polygon = CutBelow(Hull(outlines[i], scale_x, scale_y), plane, least);
    if (polygon.size() < 3) continue;
    PriorPolygon in_space;
    in_space.plane = i;
    for (const cv::Point2d& corner : polygon) {
      in_space.corners.push_back(camera.PointAt(corner.x, corner.y, plane.At(corner.x, corner.y)));
    }
    polygons.push_back(std::move(in_space));
  }
  return polygons;
}

}  // namespace stereo_sgmp
