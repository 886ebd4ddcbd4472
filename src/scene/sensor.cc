#include "scene/sensor.h"

#include <opencv2/imgproc.hpp>

namespace stereo_sgmp {
namespace {

constexpr double kWhite = 255.0;

// Light falls with the square of the distance from the principal point, by `vignetting` at half
// an image diagonal.
void Vignette(const Sensor& sensor, cv::Mat_<cv::Vec3f>* picture) {
  const double half_diagonal_squared =
      0.25 * (picture->cols * picture->cols + picture->rows * picture->rows);
  const double strength = sensor.vignetting / half_diagonal_squared;
  for (int y = 0; y < picture->rows; ++y) {
    const double dy = y - sensor.cy;
    for (int x = 0; x < picture->cols; ++x) {
      const double dx = x - sensor.cx;
      (*picture)(y, x) *= static_cast<float>(1.0 - strength * (dx * dx + dy * dy));
    }
  }
}

}  // namespace

cv::Mat Expose(const Sensor& sensor, cv::Mat_<cv::Vec3f> radiance) {
  Vignette(sensor, &radiance);
  if (sensor.blur > 0.0) cv::GaussianBlur(radiance, radiance, cv::Size(), sensor.blur);
  cv::Mat levels;
  radiance.convertTo(levels, CV_32FC3, kWhite * sensor.gain, sensor.offset);
  cv::RNG random(sensor.seed);
  cv::Mat noise(levels.size(), CV_32FC3);
  random.fill(noise, cv::RNG::NORMAL, cv::Scalar::all(0.0), cv::Scalar::all(sensor.noise));
  levels += noise;
  cv::Mat picture;
  levels.convertTo(picture, CV_8U);
  return picture;
}

}  // namespace stereo_sgmp
