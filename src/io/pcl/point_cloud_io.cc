#include "io/pcl/point_cloud_io.h"

#include <cmath>
#include <cstring>
#include <stdexcept>

#include <pcl/conversions.h>
#include <pcl/io/ply_io.h>
#include <pcl/point_cloud.h>
#include <pcl/register_point_struct.h>

#include "io/file_io.h"

namespace stereo_sgmp {
namespace {

struct PclPoint {
  float x;
  float y;
  float z;
  float rgb;  // the bytes b, g, r, 0, as everywhere in PCL
  float confidence;
};
static_assert(sizeof(PclPoint) == sizeof(CloudPoint), "PclPoint renames the fields of CloudPoint");

}  // namespace
}  // namespace stereo_sgmp

POINT_CLOUD_REGISTER_POINT_STRUCT(stereo_sgmp::PclPoint,
                                  (float, x, x)(float, y, y)(float, z, z)(float, rgb,
                                                                          rgb)(float, confidence,
                                                                               confidence))

namespace stereo_sgmp {

namespace {

// PCL refuses to write a cloud without points.
constexpr char kEmptyPly[] =
    "ply\nformat binary_little_endian 1.0\nelement vertex 0\n"
    "property float x\nproperty float y\nproperty float z\n"
    "property uchar red\nproperty uchar green\nproperty uchar blue\n"
    "property float confidence\nend_header\n";

pcl::PointCloud<PclPoint> ValidPoints(const PointCloud& cloud) {
  pcl::PointCloud<PclPoint> valid;
  valid.reserve(cloud.points.size());
  for (const CloudPoint& point : cloud.points) {
    if (!std::isfinite(point.z)) continue;
    PclPoint copy;
    std::memcpy(&copy, &point, sizeof(copy));
    valid.push_back(copy);
  }
  return valid;
}

}  // namespace

void SavePly(const std::string& path, const PointCloud& cloud) {
  const pcl::PointCloud<PclPoint> valid = ValidPoints(cloud);
  if (valid.empty()) return WriteFile(path, kEmptyPly);
  pcl::PCLPointCloud2 message;
  pcl::toPCLPointCloud2(valid, message);
  WriteAtomically(path, [&](const std::string& temporary) {
    constexpr bool kBinary = true;
    constexpr bool kWithCamera = false;
    const int error = pcl::PLYWriter().write(temporary, message, Eigen::Vector4f::Zero(),
                                             Eigen::Quaternionf::Identity(), kBinary, kWithCamera);
    if (error != 0) {
      throw std::runtime_error(path +
                               ": the cloud can't be written; check permissions and free "
                               "space.");
    }
  });
}

}  // namespace stereo_sgmp
