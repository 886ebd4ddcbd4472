#ifndef STEREO_SGMP_DISPARITY_PLANE_H_
#define STEREO_SGMP_DISPARITY_PLANE_H_

namespace stereo_sgmp {

// A plane in disparity space: d(x, y) = a x + b y + c, with x, y and d in pixels of one image.
struct DisparityPlane {
  double a = 0.0;
  double b = 0.0;
  double c = 0.0;

  double At(double x, double y) const { return a * x + b * y + c; }

  // The same surface seen in an image `factor` times larger, whose disparities are `factor` times
  // larger too; pixel centres are at integer coordinates in both.
  DisparityPlane ScaledUp(double factor) const {
    return {a, b, factor * c - (a + b) * (factor - 1.0) / 2.0};
  }
};

}  // namespace stereo_sgmp

#endif  // STEREO_SGMP_DISPARITY_PLANE_H_
