// Organised point clouds without ROS or PCL.
#ifndef STEREO_SGMP_POINT_CLOUD_H_
#define STEREO_SGMP_POINT_CLOUD_H_

#include <cstdint>
#include <limits>
#include <vector>

#include <opencv2/core.hpp>

#include "stereo_sgmp/match_result.h"
#include "stereo_sgmp/stereo_camera.h"

namespace stereo_sgmp {

// One point, laid out as a sensor_msgs/PointCloud2 with the fields x y z rgb confidence and a
// point_step of 20 on a little-endian machine, so that whole clouds are copied at once.
struct CloudPoint {
  float x;  // left camera's optical frame, unit of the baseline; NaN (all three) where invalid
  float y;
  float z;
  std::uint8_t b;
  std::uint8_t g;
  std::uint8_t r;
  std::uint8_t unused;  // 0; makes `rgb` a word 0x00RRGGBB as PCL reads it
  float confidence;     // 0..1, high = good; also set where x, y, z are NaN
};
static_assert(sizeof(CloudPoint) == 20, "copied as raw bytes");

// An organised cloud: the point of pixel (x, y) of the left image is points[y * width + x].
struct PointCloud {
  int width = 0;
  int height = 0;
  std::vector<CloudPoint> points;
};

struct CloudOptions {
  double min_confidence = 0.0;                                 // pixels below it are NaN
  double max_depth = std::numeric_limits<double>::infinity();  // points beyond it are NaN
};

// The cloud of the filtered disparity. `image` colours it: of the size of the result, 8 or 16
// bit (of which the upper 8 are taken), gray, BGR or BGRA. Uses the storage of `cloud` again.
// Throws std::invalid_argument when image and result differ in size or the image's type is
// another one, and as StereoCamera::Check.
void ComputePointCloud(const MatchResult& result, const StereoCamera& camera, const cv::Mat& image,
                       const CloudOptions& options, PointCloud* cloud);

}  // namespace stereo_sgmp

#endif  // STEREO_SGMP_POINT_CLOUD_H_
