#include "ros/camera_model.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <sstream>
#include <stdexcept>

#include "common/excerpt.h"

namespace stereo_sgmp {
namespace {

// Relative difference of two numbers that a calibration should give as equal: far more than
// rounding leaves, far less than an unrectified pair has.
constexpr double kTolerance = 1e-3;

[[noreturn]] void Refuse(const std::ostringstream& message) {
  throw std::invalid_argument(message.str());
}

bool Agree(double a, double b, double scale) { return std::abs(a - b) <= kTolerance * scale; }

// The numbers of P that matter, in pixels of the images that were sent.
struct Projection {
  double fx;
  double fy;
  double cx;
  double cy;
  double tx;  // P[3] = -fx * (distance from the left camera)
};

Projection ProjectionOf(const sensor_msgs::CameraInfo& info) {
  const double binning_x = std::max(1u, info.binning_x);
  const double binning_y = std::max(1u, info.binning_y);
  return {info.P[0] / binning_x, info.P[5] / binning_y, (info.P[2] - info.roi.x_offset) / binning_x,
          (info.P[6] - info.roi.y_offset) / binning_y, info.P[3] / binning_x};
}

// Size of the images that `info` speaks of: of the region of interest after binning.
cv::Size ImageSizeOf(const sensor_msgs::CameraInfo& info) {
  const unsigned width = info.roi.width > 0 ? info.roi.width : info.width;
  const unsigned height = info.roi.height > 0 ? info.roi.height : info.height;
  return {static_cast<int>(width / std::max(1u, info.binning_x)),
          static_cast<int>(height / std::max(1u, info.binning_y))};
}

void CheckCalibrated(const sensor_msgs::CameraInfo& info, const char* side) {
  std::ostringstream message;
  for (std::size_t i = 0; i < info.P.size(); ++i) {
    if (std::isfinite(info.P[i])) continue;
    message << side << " P[" << i << "] is " << info.P[i]
            << "; expected a finite number; calibrate the cameras";
    Refuse(message);
  }
  if (info.P[0] > 0.0 && info.P[5] > 0.0) return;
  const int entry = info.P[0] > 0.0 ? 5 : 0;
  message << side << " P[" << entry << "] is " << info.P[static_cast<std::size_t>(entry)]
          << "; expected the focal length in pixels; the camera is not calibrated, publish a "
             "camera_info with its calibration";
  Refuse(message);
}

void CheckSize(const sensor_msgs::CameraInfo& info, const char* side, cv::Size image_size) {
  const cv::Size size = ImageSizeOf(info);
  if (size == image_size) return;
  std::ostringstream message;
  message << side << " camera_info is of " << size.width << " x " << size.height
          << " pixels, the image of " << image_size.width << " x " << image_size.height
          << "; expected the same; publish the camera_info of the resized image";
  Refuse(message);
}

void CheckBaseline(const Projection& left, const Projection& right) {
  std::ostringstream message;
  if (!Agree(left.tx, 0.0, std::abs(right.tx))) {
    if (right.tx == 0.0) {
      message << "right P[3] is 0 and left P[3] is " << left.tx
              << "; expected -fx*B and 0; left and right seem to be swapped";
    } else {
      message << "left P[3] is " << left.tx
              << "; expected 0; the left camera has to be the origin of the pair";
    }
    Refuse(message);
  }
  if (right.tx < 0.0) return;
  message << "right P[3] is " << right.tx << "; expected -fx*B";
  message << (right.tx == 0.0 ? "; calibrate both cameras together as a stereo pair"
                              : ", a negative number; left and right seem to be swapped");
  Refuse(message);
}

void CheckRectified(const Projection& left, const Projection& right) {
  std::ostringstream message;
  if (!Agree(left.fx, right.fx, right.fx)) {
    message << "left P[0] is " << left.fx << ", right P[0] is " << right.fx
            << "; expected one focal length";
  } else if (!Agree(right.fx, right.fy, right.fx) || !Agree(left.fx, left.fy, left.fx)) {
    message << "right P[0] is " << right.fx << ", P[5] is " << right.fy
            << "; expected square pixels";
  } else if (!Agree(left.cy, right.cy, right.fx)) {
    message << "left P[6] is " << left.cy << ", right P[6] is " << right.cy
            << "; expected the same row";
  } else {
    return;
  }
  message << " in both rectified images; calibrate both cameras together as a stereo pair";
  Refuse(message);
}

}  // namespace

StereoCamera CameraFromInfo(const sensor_msgs::CameraInfo& left,
                            const sensor_msgs::CameraInfo& right, cv::Size image_size) {
  CheckCalibrated(left, "left");
  CheckCalibrated(right, "right");
  CheckSize(left, "left", image_size);
  CheckSize(right, "right", image_size);
  const Projection left_projection = ProjectionOf(left);
  const Projection right_projection = ProjectionOf(right);
  CheckBaseline(left_projection, right_projection);
  CheckRectified(left_projection, right_projection);

  StereoCamera camera;
  camera.focal_length = right_projection.fx;
  camera.cx = left_projection.cx;
  camera.cy = left_projection.cy;
  camera.doffs = right_projection.cx - left_projection.cx;
  camera.baseline = -right_projection.tx / right_projection.fx;
  camera.Check();  // a quotient of finite numbers need not be finite
  return camera;
}

std::string FrameIdProblem(const sensor_msgs::CameraInfo& left,
                           const sensor_msgs::CameraInfo& right) {
  if (left.header.frame_id == right.header.frame_id) return "";
  return "left camera_info has frame_id '" + Excerpt(left.header.frame_id) + "', the right one '" +
         Excerpt(right.header.frame_id) +
         "'; expected the left camera's optical frame in both; correct the right driver's "
         "frame_id (the results are in the left frame)";
}

}  // namespace stereo_sgmp
