// Surfaces for the pixels whose depth no coarse disparity shows.
#ifndef STEREO_SGMP_PRIOR_NORMALS_SURFACE_FLOOD_H_
#define STEREO_SGMP_PRIOR_NORMALS_SURFACE_FLOOD_H_

#include <cstddef>
#include <vector>

#include <opencv2/core.hpp>

#include "prior/normals/component_scales.h"
#include "prior/normals/normal_integration.h"

namespace stereo_sgmp {

// How much the image changes at each pixel (CV_8U): the largest difference of a channel within 3x3
// pixels. `image`: CV_8U.
cv::Mat_<uchar> ImageEdges(const cv::Mat& image);

// A watershed of the image: surfaces spread over what the normals connect, first where the image
// changes least, so that those of two depths meet where it changes most.
class SurfaceFlood {
 public:
  // `tolerance`: pixels by which disparities of one surface may differ. A surface that goes on in
  // a component that has others only is added to the `table`. All have to outlive this.
  SurfaceFlood(const IntegratedNormals& normals, double tolerance, ScaleTable* table)
      : normals_(normals), tolerance_(tolerance), table_(*table) {}

  // `label`: in the pixels' components the index of a scale in the table, -1 where it is to be
  // found. Stays -1 where nothing leads to. `edges` as of ImageEdges.
  void Spread(const cv::Mat_<uchar>& edges, cv::Mat_<schar>* label);

 private:
  void Leave(cv::Point from, std::size_t level, const cv::Mat_<uchar>& edges,
             cv::Mat_<schar>* label);
  int LabelIn(int to, int from, int label);

  const IntegratedNormals& normals_;
  double tolerance_;
  ScaleTable& table_;
  std::vector<std::vector<cv::Point>> reached_;  // by the largest change on the way to them
};

}  // namespace stereo_sgmp

#endif  // STEREO_SGMP_PRIOR_NORMALS_SURFACE_FLOOD_H_
