#include "prior/nearest_planes.h"

#include <cmath>
#include <cstddef>
#include <cstdint>
#include <limits>

namespace stereo_sgmp {

namespace {

void LabelRow(const PlaneSets& sets, const std::vector<DisparityPlane>& planes,
              const float* disparity, int y, cv::Mat* labels) {
  const std::uint16_t* ids = sets.ids.ptr<std::uint16_t>(y);
  std::int16_t* label = labels->ptr<std::int16_t>(y);
  for (int x = 0; x < labels->cols; ++x) {
    const PlaneSet& set = sets.sets[ids[x]];
    label[x] = -1;
    double nearest = std::numeric_limits<double>::infinity();
    for (std::size_t k = 0; k < set.count; ++k) {
      const DisparityPlane& plane = planes[static_cast<std::size_t>(set.planes[k])];
      const double distance = std::abs(plane.At(x, y) - disparity[x]);
      if (distance >= nearest) continue;
      nearest = distance;
      label[x] = set.planes[k];
    }
  }
}

}  // namespace

void LabelNearestPlanes(const PlaneSets& sets, const std::vector<DisparityPlane>& planes,
                        const cv::Mat& disparity, cv::Mat* labels, ThreadPool* threads) {
  labels->create(disparity.size(), CV_16SC1);
  const auto label_rows = [&](int begin, int end) {
    for (int y = begin; y < end; ++y) LabelRow(sets, planes, disparity.ptr<float>(y), y, labels);
  };
  if (threads != nullptr) {
    threads->ForRanges(disparity.rows, label_rows);
  } else {
    label_rows(0, disparity.rows);
  }
}

}  // namespace stereo_sgmp
