#ifndef STEREO_SGMP_IO_NORMALS_FILE_H_
#define STEREO_SGMP_IO_NORMALS_FILE_H_

#include <string>

#include <opencv2/core.hpp>

namespace stereo_sgmp {

// A normal map from a PFM file of three channels: CV_32FC3, unit vectors x right, y down, z
// forward, zero where the file has zero or what is not finite. Throws std::invalid_argument for a
// file that is missing, malformed or has one channel, and for vectors of another length than 1.
cv::Mat ReadNormals(const std::string& path);

// The same for the content of a file; `name` stands for it in the messages.
cv::Mat DecodeNormals(const std::string& bytes, const std::string& name);

}  // namespace stereo_sgmp

#endif  // STEREO_SGMP_IO_NORMALS_FILE_H_
