#ifndef STEREO_SGMP_STEREO_CAMERA_H_
#define STEREO_SGMP_STEREO_CAMERA_H_

#include <Eigen/Core>

#include "stereo_sgmp/disparity_plane.h"

namespace stereo_sgmp {

// A rectified stereo camera. Points are in the left camera's optical frame (x right, y down,
// z forward) in the unit of the baseline; metres everywhere but in Middlebury's calib files.
struct StereoCamera {
  double focal_length = 0.0;  // f, pixels, > 0
  double cx = 0.0;            // principal point of the left image, pixels
  double cy = 0.0;
  double doffs = 0.0;     // cx_right - cx_left, pixels: z = f b / (d + doffs)
  double baseline = 0.0;  // b > 0

  // Throws std::invalid_argument naming the value that can't be: f, b not positive or not finite.
  void Check() const;

  // Depth of a disparity; +infinity where d + doffs <= 0.
  double DepthOf(double disparity) const;
  double DisparityOf(double depth) const;
  Eigen::Vector3d PointAt(double x, double y, double disparity) const;

  // The plane n.X = h in space, n a unit vector towards the camera (h <= 0), of a disparity
  // plane. Exact (Eq. 15 of the paper solved for n and h, with doffs and the principal point).
  struct SpacePlane {
    Eigen::Vector3d normal;
    double distance = 0.0;  // h; -h is the distance of the plane from the camera
  };
  SpacePlane ToSpace(const DisparityPlane& plane) const;
  DisparityPlane ToDisparity(const SpacePlane& plane) const;
};

}  // namespace stereo_sgmp

#endif  // STEREO_SGMP_STEREO_CAMERA_H_
