#ifndef STEREO_SGMP_ROS_CALIBRATION_REPORT_H_
#define STEREO_SGMP_ROS_CALIBRATION_REPORT_H_

#include <string>

#include <opencv2/core.hpp>

#include "stereo_sgmp/options.h"
#include "stereo_sgmp/stereo_camera.h"

namespace stereo_sgmp {

// What can be expected of a camera (baseline in metres) with these options, in a few lines: the
// calibration, the depths that are searched, the error of depths at 1, 5 and 10 m (one standard
// deviation of a sure pixel), memory, threads and SIMD target.
std::string CalibrationReport(const StereoCamera& camera, cv::Size image_size,
                              const Options& options);

// Logs the report once for each calibration, size and range of a stream.
class CalibrationLog {
 public:
  // The report where it is a new one, else empty.
  std::string Update(const StereoCamera& camera, cv::Size image_size, const Options& options);

 private:
  std::string last_;
};

}  // namespace stereo_sgmp

#endif  // STEREO_SGMP_ROS_CALIBRATION_REPORT_H_
