#ifndef STEREO_SGMP_GEOMETRY_NORMALS_FROM_DISPARITY_H_
#define STEREO_SGMP_GEOMETRY_NORMALS_FROM_DISPARITY_H_

#include <opencv2/core.hpp>

#include "stereo_sgmp/stereo_camera.h"

namespace stereo_sgmp {

// Unit normals of a disparity map (CV_32F, pixels; not finite where it is not known): CV_32FC3, x
// right, y down, z forward, turned towards the camera; zero where the disparity is not known or has
// too few neighbours on its surface.
//
// In disparity space a plane is a plane and noise is even. The normal of a pixel is that of the
// least-squares plane over a window of 7 x 7 pixels, exact on planes: centred on the pixel where a
// plane fits there, otherwise the window of nine that hold the pixel where it fits best, so that
// edges and creases stay sharp. Neighbours whose disparity differs from the pixel's by more than
// their distance belong to another surface and do not count.
//
// Throws std::invalid_argument for another type of map and as StereoCamera::Check.
cv::Mat NormalsFromDisparity(const cv::Mat& disparity, const StereoCamera& camera);

}  // namespace stereo_sgmp

#endif  // STEREO_SGMP_GEOMETRY_NORMALS_FROM_DISPARITY_H_
