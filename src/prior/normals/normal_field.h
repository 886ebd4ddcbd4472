// A normal map as what a surface does from one pixel to the next.
#ifndef STEREO_SGMP_PRIOR_NORMALS_NORMAL_FIELD_H_
#define STEREO_SGMP_PRIOR_NORMALS_NORMAL_FIELD_H_

#include <Eigen/Core>
#include <opencv2/core.hpp>

#include "stereo_sgmp/stereo_camera.h"

namespace stereo_sgmp {

class NormalField {
 public:
  struct Pixel {
    Eigen::Vector3d normal = Eigen::Vector3d::Zero();  // unit length; zero where unknown
    Eigen::Vector3d ray = Eigen::Vector3d::Zero();     // (u, v, f) / f
    bool at_discontinuity = false;
  };
  // From a pixel p to a neighbour q, in delta = log(d + doffs).
  struct Step {
    double delta = 0.0;   // g
    double weight = 0.0;  // 0 where the surface isn't continued
  };

  // The arguments of IntegrateNormals, checked; they have to outlive the field.
  NormalField(const cv::Mat& normals, const cv::Mat& discontinuities, const StereoCamera& camera)
      : normals_(normals), discontinuities_(discontinuities), camera_(camera) {}

  Pixel At(int x, int y) const;

  // Between neighbours p and q on a plane n.X = h, the paper's d + doffs = (b/h) n.(u, v, f)
  // (Eq. 15) gives
  //   delta_q - delta_p = g = log[n.(u_q, v_q, f) / n.(u_p, v_p, f)],
  // whatever h; g is the mean over n in {n_p, n_q}. Where the normals differ by more than 0.3
  // (17 degrees), p and q are taken to be of two surfaces.
  static Step Between(const Pixel& p, const Pixel& q);

 private:
  const cv::Mat& normals_;
  const cv::Mat& discontinuities_;
  const StereoCamera& camera_;
};

}  // namespace stereo_sgmp

#endif  // STEREO_SGMP_PRIOR_NORMALS_NORMAL_FIELD_H_
