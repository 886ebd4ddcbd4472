// calib.txt of the Middlebury stereo evaluation v3.
#ifndef STEREO_SGMP_IO_CALIB_H_
#define STEREO_SGMP_IO_CALIB_H_

#include <string>

#include <opencv2/core.hpp>

#include "stereo_sgmp/stereo_camera.h"

namespace stereo_sgmp {

struct Calibration {
  StereoCamera camera;      // baseline in metres (the file holds millimetres)
  cv::Size size;            // of the images; 0 x 0 where the file does not say
  int num_disparities = 0;  // ndisp, a bound on the disparities; 0 where the file does not say
};

// Needs the keys cam0, cam1 and baseline; reads doffs (otherwise from cam0 and cam1), width,
// height and ndisp; ignores other keys. Throws std::invalid_argument naming file, line and key.
Calibration ReadCalibration(const std::string& path);

// The same for the content of a file; `name` stands for it in the messages.
Calibration ParseCalibration(const std::string& text, const std::string& name);

// Writes what ReadCalibration reads, without the keys of what is not known. Throws
// std::runtime_error when the file can't be written.
void WriteCalibration(const std::string& path, const Calibration& calibration);

}  // namespace stereo_sgmp

#endif  // STEREO_SGMP_IO_CALIB_H_
