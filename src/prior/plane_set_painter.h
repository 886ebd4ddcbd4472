#ifndef STEREO_SGMP_PRIOR_PLANE_SET_PAINTER_H_
#define STEREO_SGMP_PRIOR_PLANE_SET_PAINTER_H_

#include <cstdint>
#include <vector>

#include <opencv2/core.hpp>

#include "prior/plane_sets.h"

namespace stereo_sgmp {

// Builds plane sets from the areas of planes, one plane after the other. Keeps its buffers.
class PlaneSetPainter {
 public:
  // Begins an image without planes.
  void Start(cv::Size size);

  // Adds a plane to the pixels where `area` (CV_8U) is not 0; the pixel (0, 0) of `area` lies at
  // `corner` of the image. Each plane is painted once. Pixels that hold PlaneSet::kMaxFound
  // already stay as they are, so the more important planes come first.
  void Paint(std::int16_t plane, const cv::Mat& area, cv::Point corner);

  // Gives the pixels without plane that of `labels` (CV_16S, -1 for none) alone.
  void FillEmpty(const cv::Mat& labels);

  const PlaneSets& sets() const { return sets_; }

 private:
  std::uint16_t WithPlane(std::uint16_t set, std::int16_t plane);
  std::uint16_t SetOf(std::int16_t plane);

  std::vector<std::uint16_t> extended_;  // per set: it with the current plane; 0 = not yet made
  std::vector<std::uint16_t> single_;    // per plane: the set of it alone; 0 = not yet made
  PlaneSets sets_;
};

}  // namespace stereo_sgmp

#endif  // STEREO_SGMP_PRIOR_PLANE_SET_PAINTER_H_
