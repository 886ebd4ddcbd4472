#ifndef STEREO_SGMP_SCENE_SENSOR_H_
#define STEREO_SGMP_SCENE_SENSOR_H_

#include <cstdint>

#include <opencv2/core.hpp>

namespace stereo_sgmp {

// What a camera makes of the light; fields as in SceneQuality.
struct Sensor {
  double cx = 0.0;  // principal point, pixels
  double cy = 0.0;
  double vignetting = 0.0;
  double blur = 0.0;
  double gain = 1.0;
  double offset = 0.0;
  double noise = 0.0;
  std::uint64_t seed = 0;  // of the noise
};

// The CV_8UC3 picture of `radiance` (0..1, of which it takes the memory).
cv::Mat Expose(const Sensor& sensor, cv::Mat_<cv::Vec3f> radiance);

}  // namespace stereo_sgmp

#endif  // STEREO_SGMP_SCENE_SENSOR_H_
