// Thinning of point clouds by PCL. Apart from geometry/, so that only who filters links PCL.
#ifndef STEREO_SGMP_GEOMETRY_PCL_CLOUD_FILTER_H_
#define STEREO_SGMP_GEOMETRY_PCL_CLOUD_FILTER_H_

#include "stereo_sgmp/point_cloud.h"

namespace stereo_sgmp {

struct CloudFilterOptions {
  // Edge of the cubes of which each becomes one point, the mean of its points; 0: off.
  double voxel_size = 0.0;
  // Points whose mean distance to so many nearest neighbours is more than
  // outlier_deviations standard deviations above the average are dropped; 0: off.
  int outlier_neighbors = 0;
  double outlier_deviations = 1.0;
};

// The valid points of a cloud, filtered: first by voxels, then by outliers. The result is not
// organised: its height is 1. A voxel size too small for the extent of the cloud thins nothing.
PointCloud FilterCloud(const PointCloud& cloud, const CloudFilterOptions& options);

}  // namespace stereo_sgmp

#endif  // STEREO_SGMP_GEOMETRY_PCL_CLOUD_FILTER_H_
