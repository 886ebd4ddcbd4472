// Point clouds in PCL's file formats. Apart from io/, so that only who writes clouds links PCL.
#ifndef STEREO_SGMP_IO_PCL_POINT_CLOUD_IO_H_
#define STEREO_SGMP_IO_PCL_POINT_CLOUD_IO_H_

#include <string>

#include "stereo_sgmp/point_cloud.h"

namespace stereo_sgmp {

// Writes the valid points as a binary PLY file with the vertex properties x y z, red green blue
// and confidence. Throws std::runtime_error when the file can't be written.
void SavePly(const std::string& path, const PointCloud& cloud);

}  // namespace stereo_sgmp

#endif  // STEREO_SGMP_IO_PCL_POINT_CLOUD_IO_H_
