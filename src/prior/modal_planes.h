// One plane per superpixel: SGM-EPi of the paper.
#ifndef STEREO_SGMP_PRIOR_MODAL_PLANES_H_
#define STEREO_SGMP_PRIOR_MODAL_PLANES_H_

#include <cstdint>
#include <vector>

#include <opencv2/core.hpp>

#include "prior/plane_hypotheses.h"
#include "prior/superpixels.h"

namespace stereo_sgmp {

// Gives each superpixel the plane most often assigned to its pixels (ties: the plane of larger
// area), or none where fewer than `min_support` (0..1) of them carry it. Keeps its buffers.
class ModalPlanes {
 public:
  void Assign(const PlaneMap& map, const Superpixels& superpixels, double min_support);

  // CV_16S like PlaneMap::labels.
  const cv::Mat& labels() const { return labels_; }

 private:
  void GroupBySuperpixel(const PlaneMap& map, const Superpixels& superpixels);
  std::int16_t ModeOf(int superpixel, double min_support);

  std::vector<int> first_;                    // per superpixel: its entries of plane_of_pixel_
  std::vector<int> next_;                     // where its next one goes
  std::vector<std::int16_t> plane_of_pixel_;  // sorted by superpixel
  std::vector<int> votes_;                    // per plane, 0 between calls
  std::vector<std::int16_t> plane_of_superpixel_;
  cv::Mat labels_;
};

}  // namespace stereo_sgmp

#endif  // STEREO_SGMP_PRIOR_MODAL_PLANES_H_
