#include "stereo_sgmp/stereo_camera.h"

#include <cmath>
#include <limits>
#include <sstream>
#include <stdexcept>
#include <string>

namespace stereo_sgmp {
namespace {

[[noreturn]] void Reject(const char* name, double value, const char* expectation) {
  std::ostringstream message;
  message << name << " of the stereo camera is " << value << ", but it has to be " << expectation
          << "; check the calibration.";
  throw std::invalid_argument(message.str());
}

void CheckPositive(const char* name, double value) {
  if (!std::isfinite(value) || value <= 0.0) Reject(name, value, "positive and finite");
}

void CheckFinite(const char* name, double value) {
  if (!std::isfinite(value)) Reject(name, value, "finite");
}

}  // namespace

void StereoCamera::Check() const {
  CheckPositive("focal_length", focal_length);
  CheckPositive("baseline", baseline);
  CheckFinite("cx", cx);
  CheckFinite("cy", cy);
  CheckFinite("doffs", doffs);
}

double StereoCamera::DepthOf(double disparity) const {
  const double shifted = disparity + doffs;
  if (shifted <= 0.0) return std::numeric_limits<double>::infinity();
  return focal_length * baseline / shifted;
}

double StereoCamera::DisparityOf(double depth) const {
  return focal_length * baseline / depth - doffs;
}

Eigen::Vector3d StereoCamera::PointAt(double x, double y, double disparity) const {
  const double z = DepthOf(disparity);
  return {(x - cx) * z / focal_length, (y - cy) * z / focal_length, z};
}

// With u = x - cx and v = y - cy, Eq. 15 reads d + doffs = (b/h) (n_x u + n_y v + n_z f).
// Comparing coefficients gives the vector (b/h) n, whose length and direction are b/|h| and n.
StereoCamera::SpacePlane StereoCamera::ToSpace(const DisparityPlane& plane) const {
  const double at_center = plane.At(cx, cy) + doffs;
  const Eigen::Vector3d scaled_normal(plane.a, plane.b, at_center / focal_length);
  const double length = scaled_normal.norm();
  if (length == 0.0) {  // d + doffs = 0 everywhere: the plane at infinity
    return {-Eigen::Vector3d::UnitZ(), -std::numeric_limits<double>::infinity()};
  }
  // h < 0 is the sign that turns n towards the camera: n.(0 - X) = -h.
  return {-scaled_normal / length, -baseline / length};
}

DisparityPlane StereoCamera::ToDisparity(const SpacePlane& plane) const {
  if (plane.distance == 0.0) {
    throw std::invalid_argument(
        "The plane's distance is 0, but a plane through the camera's centre has no disparities; "
        "take one that the camera sees from a side.");
  }
  const Eigen::Vector3d scaled_normal = baseline / plane.distance * plane.normal;
  const double a = scaled_normal.x();
  const double b = scaled_normal.y();
  return {a, b, scaled_normal.z() * focal_length - a * cx - b * cy - doffs};
}

}  // namespace stereo_sgmp
