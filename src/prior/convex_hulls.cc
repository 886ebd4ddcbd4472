#include "prior/convex_hulls.h"

#include <cstddef>
#include <limits>

#include <opencv2/imgproc.hpp>

namespace stereo_sgmp {
namespace {

constexpr std::size_t kMaxSets = std::numeric_limits<std::uint16_t>::max();

}  // namespace

void ConvexHulls::Build(const PlaneMap& map) {
  sets_.sets.assign(1, PlaneSet());
  sets_.ids.create(map.labels.size(), CV_16UC1);
  sets_.ids.setTo(0);
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
  extended_.assign(sets_.sets.size(), 0);
  for (int y = 0; y < box.height; ++y) {
    const std::uint8_t* mask = inside.ptr<std::uint8_t>(y);
    std::uint16_t* ids = sets_.ids.ptr<std::uint16_t>(box.y + y) + box.x;
    for (int x = 0; x < box.width; ++x) {
      if (mask[x] != 0) ids[x] = WithPlane(ids[x], plane);
    }
  }
}

std::uint16_t ConvexHulls::WithPlane(std::uint16_t set, std::int16_t plane) {
  std::uint16_t& extended = extended_[set];
  if (extended != 0) return extended;
  const bool full = sets_.sets[set].count == PlaneSet::kMaxPlanes;
  if (full || sets_.sets.size() >= kMaxSets) return set;
  PlaneSet larger = sets_.sets[set];
  larger.planes[larger.count++] = plane;
  extended = static_cast<std::uint16_t>(sets_.sets.size());
  sets_.sets.push_back(larger);
  return extended;
}

}  // namespace stereo_sgmp
