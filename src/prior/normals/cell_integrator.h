#ifndef STEREO_SGMP_PRIOR_NORMALS_CELL_INTEGRATOR_H_
#define STEREO_SGMP_PRIOR_NORMALS_CELL_INTEGRATOR_H_

#include <array>
#include <vector>

#include <Eigen/Core>
#include <opencv2/core.hpp>

#include "prior/normals/normal_integration.h"
#include "stereo_sgmp/stereo_camera.h"

namespace stereo_sgmp {

// Integrates the normals of one grid cell after the other; keeps its storage between cells. Between
// neighbours p and q on a plane n.X = h, the paper's d + doffs = (b/h) n.(u, v, f) (Eq. 15) gives
//   delta_q - delta_p = g = log[n.(u_q, v_q, f) / n.(u_p, v_p, f)],
// whatever h; g is the mean over n in {n_p, n_q}. Minimises sum w (delta_q - delta_p - g)^2.
class CellIntegrator {
 public:
  // The arguments of IntegrateNormals, checked; they have to outlive the integrator.
  CellIntegrator(const cv::Mat& normals, const cv::Mat& discontinuities, const StereoCamera& camera)
      : normals_(normals), discontinuities_(discontinuities), camera_(camera) {}

  // Writes the pixels of `cell`.
  void Integrate(const cv::Rect& cell, IntegratedNormals* result);

 private:
  struct Pixel {
    Eigen::Vector3d normal = Eigen::Vector3d::Zero();  // unit length; zero where unknown
    Eigen::Vector3d ray = Eigen::Vector3d::Zero();     // (u, v, f) / f
    bool at_discontinuity = false;
  };
  // From a pixel to its right or lower neighbour.
  struct Edge {
    double step = 0.0;    // g
    double weight = 0.0;  // w; 0 where the surface isn't continued
  };
  enum Axis { kRight, kDown };
  // An edge as met from one of its ends; `step` is that to the neighbour.
  struct Link {
    int neighbor = 0;
    double step = 0.0;
    double weight = 0.0;
  };

  void LoadPixels();
  void ConnectPixels();
  static Edge Connect(const Pixel& p, const Pixel& q);
  // To the neighbours above, left, right and below; of weight 0 where there is none.
  std::array<Link, 4> LinksOf(int pixel) const;
  // Finds the components, and the start of the solution by adding the steps on the way.
  void FloodComponents();
  void Flood(int seed);
  void Solve();
  void Store(IntegratedNormals* result);

  const cv::Mat& normals_;
  const cv::Mat& discontinuities_;
  const StereoCamera& camera_;
  cv::Rect cell_;
  std::vector<Pixel> pixels_;               // of the cell, row by row
  std::vector<std::array<Edge, 2>> edges_;  // by pixel and Axis
  std::vector<int> seed_;  // first pixel of the pixel's component; -1 where unknown
  std::vector<double> delta_;
  std::vector<int> reached_;
};

}  // namespace stereo_sgmp

#endif  // STEREO_SGMP_PRIOR_NORMALS_CELL_INTEGRATOR_H_
