#include "prior/plane_set_painter.h"

#include <cstddef>
#include <limits>

namespace stereo_sgmp {
namespace {

constexpr std::size_t kMaxSets = std::numeric_limits<std::uint16_t>::max();

}  // namespace

void PlaneSetPainter::Start(cv::Size size) {
  sets_.sets.assign(1, PlaneSet());
  sets_.ids.create(size, CV_16UC1);
  sets_.ids.setTo(0);
}

void PlaneSetPainter::FillEmpty(const cv::Mat& labels) {
  single_.clear();
  for (int y = 0; y < labels.rows; ++y) {
    const std::int16_t* row = labels.ptr<std::int16_t>(y);
    std::uint16_t* ids = sets_.ids.ptr<std::uint16_t>(y);
    for (int x = 0; x < labels.cols; ++x) {
      if (ids[x] == 0 && row[x] >= 0) ids[x] = SetOf(row[x]);
    }
  }
}

// The set of one plane, which is made when it is first asked for; the empty one where there can
// be no more sets.
std::uint16_t PlaneSetPainter::SetOf(std::int16_t plane) {
  const auto index = static_cast<std::size_t>(plane);
  if (single_.size() <= index) single_.resize(index + 1, 0);
  if (single_[index] != 0 || sets_.sets.size() >= kMaxSets) return single_[index];
  single_[index] = static_cast<std::uint16_t>(sets_.sets.size());
  PlaneSet set;
  set.count = 1;
  set.planes[0] = plane;
  sets_.sets.push_back(set);
  return single_[index];
}

void PlaneSetPainter::Paint(std::int16_t plane, const cv::Mat& area, cv::Point corner) {
  extended_.assign(sets_.sets.size(), 0);
  for (int y = 0; y < area.rows; ++y) {
    const std::uint8_t* mask = area.ptr<std::uint8_t>(y);
    std::uint16_t* ids = sets_.ids.ptr<std::uint16_t>(corner.y + y) + corner.x;
    for (int x = 0; x < area.cols; ++x) {
      if (mask[x] != 0) ids[x] = WithPlane(ids[x], plane);
    }
  }
}

std::uint16_t PlaneSetPainter::WithPlane(std::uint16_t set, std::int16_t plane) {
  std::uint16_t& extended = extended_[set];
  if (extended != 0) return extended;
  const bool full = sets_.sets[set].count == PlaneSet::kMaxFound;
  if (full || sets_.sets.size() >= kMaxSets) return set;
  PlaneSet larger = sets_.sets[set];
  larger.planes[larger.count++] = plane;
  extended = static_cast<std::uint16_t>(sets_.sets.size());
  sets_.sets.push_back(larger);
  return extended;
}

}  // namespace stereo_sgmp
