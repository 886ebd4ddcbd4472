#include "prior/nearest_planes.h"

#include <cmath>
#include <cstddef>
#include <cstdint>
#include <limits>

namespace stereo_sgmp {

void LabelNearestPlanes(const PlaneSets& sets, const std::vector<DisparityPlane>& planes,
                        const cv::Mat& disparity, cv::Mat* labels) {
  labels->create(disparity.size(), CV_16SC1);
  for (int y = 0; y < disparity.rows; ++y) {
    const float* d = disparity.ptr<float>(y);
    const std::uint16_t* ids = sets.ids.ptr<std::uint16_t>(y);
    std::int16_t* label = labels->ptr<std::int16_t>(y);
    for (int x = 0; x < disparity.cols; ++x) {
      const PlaneSet& set = sets.sets[ids[x]];
      label[x] = -1;
      double nearest = std::numeric_limits<double>::infinity();
      for (std::size_t k = 0; k < set.count; ++k) {
        const DisparityPlane& plane = planes[static_cast<std::size_t>(set.planes[k])];
        const double distance = std::abs(plane.At(x, y) - d[x]);
        if (distance >= nearest) continue;
        nearest = distance;
        label[x] = set.planes[k];
      }
    }
  }
}

}  // namespace stereo_sgmp
