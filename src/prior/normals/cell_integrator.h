#ifndef STEREO_SGMP_PRIOR_NORMALS_CELL_INTEGRATOR_H_
#define STEREO_SGMP_PRIOR_NORMALS_CELL_INTEGRATOR_H_

#include <array>
#include <vector>

#include <opencv2/core.hpp>

#include "prior/normals/normal_field.h"
#include "prior/normals/normal_integration.h"

namespace stereo_sgmp {

// Integrates the normals of one grid cell after the other; keeps its storage between cells.
// Minimises sum w (delta_q - delta_p - g)^2 over neighbours p and q, with g and w as of
// NormalField::Between.
class CellIntegrator {
 public:
  // The field has to outlive the integrator.
  explicit CellIntegrator(const NormalField& field) : field_(field) {}

  // Writes the pixels of `cell`, the `index`-th of the grid.
  void Integrate(const cv::Rect& cell, int index, IntegratedNormals* result);

 private:
  enum Axis { kRight, kDown };
  // An edge as met from one of its ends; `step` is that to the neighbour.
  struct Link {
    int neighbor = 0;
    double step = 0.0;
    double weight = 0.0;
  };

  void LoadPixels();
  void ConnectPixels();
  // To the neighbours above, left, right and below; of weight 0 where there is none.
  std::array<Link, 4> LinksOf(int pixel) const;
  // Finds the components, and the start of the solution by adding the steps on the way.
  void FloodComponents();
  void Flood(int seed);
  void Solve();
  void Store(int index, IntegratedNormals* result);

  const NormalField& field_;
  cv::Rect cell_;
  std::vector<NormalField::Pixel> pixels_;  // of the cell, row by row
  // By pixel and Axis: from a pixel to its right or lower neighbour.
  std::vector<std::array<NormalField::Step, 2>> edges_;
  std::vector<int> seed_;  // first pixel of the pixel's component; -1 where unknown
  std::vector<double> delta_;
  std::vector<int> reached_;
};

}  // namespace stereo_sgmp

#endif  // STEREO_SGMP_PRIOR_NORMALS_CELL_INTEGRATOR_H_
