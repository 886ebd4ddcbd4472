// Normal maps of surfaces that are known exactly.
#ifndef STEREO_SGMP_TEST_PRIOR_NORMALS_NORMAL_MAPS_H_
#define STEREO_SGMP_TEST_PRIOR_NORMALS_NORMAL_MAPS_H_

#include <opencv2/core.hpp>

#include "stereo_sgmp/disparity_plane.h"
#include "stereo_sgmp/stereo_camera.h"

namespace stereo_sgmp {

// With its principal point off the centre of the images, and doffs.
inline StereoCamera OffCenterCamera() {
  StereoCamera camera;
  camera.focal_length = 310.0;
  camera.cx = 11.3;
  camera.cy = 64.8;
  camera.doffs = 23.7;
  camera.baseline = 0.12;
  return camera;
}

// A disparity map and the normals of what it shows.
struct KnownSurface {
  explicit KnownSurface(cv::Size size) : normals(size), disparity(size, 0.0) {}

  void Draw(const cv::Rect& where, const DisparityPlane& plane, const StereoCamera& camera) {
    const Eigen::Vector3d n = camera.ToSpace(plane).normal;
    for (int y = where.y; y < where.y + where.height; ++y) {
      for (int x = where.x; x < where.x + where.width; ++x) {
        normals(y, x) = cv::Vec3f(cv::Vec3d(n.x(), n.y(), n.z()));
        disparity(y, x) = plane.At(x, y);
      }
    }
  }

  cv::Mat_<cv::Vec3f> normals;
  cv::Mat_<double> disparity;
};

inline KnownSurface PlaneSurface(cv::Size size, const DisparityPlane& plane,
                                 const StereoCamera& camera) {
  KnownSurface surface(size);
  surface.Draw({0, 0, size.width, size.height}, plane, camera);
  return surface;
}

}  // namespace stereo_sgmp

#endif  // STEREO_SGMP_TEST_PRIOR_NORMALS_NORMAL_MAPS_H_
