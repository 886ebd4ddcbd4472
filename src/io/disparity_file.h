// Disparity surfaces and depth maps in the formats that data sets come in.
#ifndef STEREO_SGMP_IO_DISPARITY_FILE_H_
#define STEREO_SGMP_IO_DISPARITY_FILE_H_

#include <string>

#include <opencv2/core.hpp>

#include "stereo_sgmp/stereo_camera.h"

namespace stereo_sgmp {

// A disparity map: CV_32F, pixels, +infinity where it is not known. disparity = value / scale;
// scale 0 takes that of the format:
//   name ends in .pfm      floats, scale 1; what is not finite is not known
//   16-bit gray picture    scale 256 as in KITTI; 0 is not known
//   8-bit gray picture     scale 1, of Middlebury 2001 to 2006 the factor of the set; 0 is not
//   known
// Throws std::invalid_argument for a file that is missing, malformed or of several channels, and
// for a scale that is negative or not finite.
cv::Mat ReadDisparity(const std::string& path, double scale);

// The same for the content of a file called `name`.
cv::Mat DecodeDisparity(const std::string& bytes, const std::string& name, double scale);

// A depth map z as disparities f b / z - doffs: as ReadDisparity returns them. A .pfm file holds
// the unit of the baseline (metres), a 16-bit gray picture millimetres; depths that are 0, negative
// or not finite are not known. Throws as ReadDisparity, for an 8-bit picture, and as
// StereoCamera::Check.
cv::Mat ReadDepthAsDisparity(const std::string& path, const StereoCamera& camera);

// The same for the content of a file called `name`.
cv::Mat DecodeDepthAsDisparity(const std::string& bytes, const std::string& name,
                               const StereoCamera& camera);

}  // namespace stereo_sgmp

#endif  // STEREO_SGMP_IO_DISPARITY_FILE_H_
