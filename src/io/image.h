#ifndef STEREO_SGMP_IO_IMAGE_H_
#define STEREO_SGMP_IO_IMAGE_H_

#include <string>

#include <opencv2/core.hpp>

namespace stereo_sgmp {

// Reads a picture as it is stored: 8 or 16 bit, gray, BGR or BGRA. Throws std::invalid_argument
// for a file that is missing, empty, truncated, no picture or of another type.
cv::Mat LoadImage(const std::string& path);

// The same for the content of a file; `name` stands for it in the messages.
cv::Mat DecodeImage(const std::string& bytes, const std::string& name);

// Throws std::invalid_argument unless both images have one size and one type.
void CheckPair(const cv::Mat& left, const std::string& left_name, const cv::Mat& right,
               const std::string& right_name);

// The image in 8 bit; of 16 bit, the upper ones.
cv::Mat To8Bit(const cv::Mat& image);

// Throws std::invalid_argument when no picture format has the extension of `path`.
void CheckImageName(const std::string& path);

// Writes a picture whose format the extension of `path` tells (.png, .jpg ...). Throws as
// CheckImageName, and std::runtime_error when the file can't be written.
void SaveImage(const std::string& path, const cv::Mat& image);

}  // namespace stereo_sgmp

#endif  // STEREO_SGMP_IO_IMAGE_H_
