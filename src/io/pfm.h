#ifndef STEREO_SGMP_IO_PFM_H_
#define STEREO_SGMP_IO_PFM_H_

#include <string>

#include <opencv2/core.hpp>

namespace stereo_sgmp {

// Reads a Portable Float Map of either byte order: CV_32FC1 for "Pf", CV_32FC3 for "PF" with the
// channels in the file's order. The first row of the result is the top of the picture. The
// magnitude of the scale is ignored, as usual for disparities. Throws std::invalid_argument with
// what was found and what was expected.
cv::Mat ReadPfm(const std::string& path);

// The same for the content of a file; `name` stands for it in the messages.
cv::Mat DecodePfm(const std::string& bytes, const std::string& name);

// Writes CV_32FC1 or CV_32FC3 in the byte order of this machine. Throws std::invalid_argument for
// another type or an empty image and std::runtime_error when the file can't be written.
void WritePfm(const std::string& path, const cv::Mat& image);

}  // namespace stereo_sgmp

#endif  // STEREO_SGMP_IO_PFM_H_
