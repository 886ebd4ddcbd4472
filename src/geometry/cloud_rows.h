#ifndef STEREO_SGMP_GEOMETRY_CLOUD_ROWS_H_
#define STEREO_SGMP_GEOMETRY_CLOUD_ROWS_H_

#include <opencv2/core.hpp>

#include "stereo_sgmp/match_result.h"
#include "stereo_sgmp/point_cloud.h"
#include "stereo_sgmp/stereo_camera.h"

namespace stereo_sgmp {

// The points of ComputePointCloud a row at a time, for who copies them on while they are in the
// cache. Result and image have to outlive it.
class CloudRows {
 public:
  // Throws as ComputePointCloud.
  CloudRows(const MatchResult& result, const StereoCamera& camera, const cv::Mat& image,
            const CloudOptions& options);

  int width() const { return result_.dense.cols; }
  int height() const { return result_.dense.rows; }

  // `points` has room for width().
  void Row(int y, CloudPoint* points) const;

 private:
  void PlaceRow(int y, CloudPoint* points) const;

  const MatchResult& result_;
  const cv::Mat image_;
  // In the precision of the points.
  const float focal_length_;
  const float baseline_;
  const float cx_;
  const float cy_;
  const float doffs_;
  const float max_depth_;
  const float min_confidence_;
};

}  // namespace stereo_sgmp

#endif  // STEREO_SGMP_GEOMETRY_CLOUD_ROWS_H_
