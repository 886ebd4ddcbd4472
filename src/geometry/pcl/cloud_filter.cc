#include "geometry/pcl/cloud_filter.h"

#include <cmath>
#include <cstddef>
#include <cstdint>
#include <cstring>
#include <memory>

#include <pcl/PCLPointCloud2.h>
#include <pcl/filters/statistical_outlier_removal.h>
#include <pcl/filters/voxel_grid.h>

namespace stereo_sgmp {
namespace {

pcl::PCLPointField FloatField(const char* name, std::size_t offset) {
  pcl::PCLPointField field;
  field.name = name;
  field.offset = static_cast<std::uint32_t>(offset);
  field.datatype = pcl::PCLPointField::FLOAT32;
  field.count = 1;
  return field;
}

// The valid points.
pcl::PCLPointCloud2::Ptr ToPcl(const PointCloud& cloud) {
  auto message = std::make_unique<pcl::PCLPointCloud2>();
  message->fields = {
      FloatField("x", offsetof(CloudPoint, x)), FloatField("y", offsetof(CloudPoint, y)),
      FloatField("z", offsetof(CloudPoint, z)), FloatField("rgb", offsetof(CloudPoint, b)),
      FloatField("confidence", offsetof(CloudPoint, confidence))};
  message->point_step = sizeof(CloudPoint);
  message->data.resize(cloud.points.size() * sizeof(CloudPoint));
  std::uint32_t count = 0;
  for (const CloudPoint& point : cloud.points) {
    if (!std::isfinite(point.z)) continue;
    std::memcpy(message->data.data() + count++ * sizeof(point), &point, sizeof(point));
  }
  message->data.resize(count * sizeof(CloudPoint));
  message->width = count;
  message->height = 1;
  message->row_step = count * message->point_step;
  message->is_dense = true;
  return pcl::PCLPointCloud2::Ptr(message.release());
}

PointCloud FromPcl(const pcl::PCLPointCloud2& message) {
  PointCloud cloud;
  cloud.width = static_cast<int>(message.width);
  cloud.height = 1;
  cloud.points.resize(message.width);
  // PCL keeps the fields where they were.
  if (message.width > 0) {
    std::memcpy(cloud.points.data(), message.data.data(), message.width * sizeof(CloudPoint));
  }
  for (CloudPoint& point : cloud.points) point.unused = 0;
  return cloud;
}

template <class Filter>
pcl::PCLPointCloud2::Ptr Apply(const pcl::PCLPointCloud2::Ptr& cloud, Filter* filter) {
  pcl::PCLPointCloud2::Ptr filtered(new pcl::PCLPointCloud2);
  filter->setInputCloud(cloud);
  filter->filter(*filtered);
  return filtered;
}

}  // namespace

PointCloud FilterCloud(const PointCloud& cloud, const CloudFilterOptions& options) {
  pcl::PCLPointCloud2::Ptr points = ToPcl(cloud);
  if (options.voxel_size > 0.0 && points->width > 0) {
    pcl::VoxelGrid<pcl::PCLPointCloud2> filter;
    const float edge = static_cast<float>(options.voxel_size);
    filter.setLeafSize(edge, edge, edge);
    points = Apply(points, &filter);
  }
  // Fewer points have no such neighbourhood.
  const int neighbors = options.outlier_neighbors;
  if (neighbors > 0 && points->width > static_cast<std::uint32_t>(neighbors)) {
    pcl::StatisticalOutlierRemoval<pcl::PCLPointCloud2> filter;
    filter.setMeanK(neighbors);
    filter.setStddevMulThresh(options.outlier_deviations);
    points = Apply(points, &filter);
  }
  return FromPcl(*points);
}

}  // namespace stereo_sgmp
