// Which pixels of a disparity map are good enough to fit planes to.
#ifndef STEREO_SGMP_PRIOR_CONFIDENT_PIXELS_H_
#define STEREO_SGMP_PRIOR_CONFIDENT_PIXELS_H_

#include <opencv2/core.hpp>

#include "common/thread_pool.h"

namespace stereo_sgmp {

// The gate is loose on purpose: planes are fitted robustly, and pixels that are missing harm the
// prior more than pixels that are wrong. Keeps its buffers from call to call.
class ConfidentPixels {
 public:
  // Marks the pixels whose uncertainty U_p is within the `keep_quantile` (0..1) of all and whose
  // match agrees with the right image's own winner within one disparity.
  //   uncertainty:  CV_16U, low = good
  //   disparity:    CV_32F, pixels
  //   right_winner: CV_16U, winner of each pixel of the right image as an index that counts from
  //                 min_disparity; values beyond the search range mean that it has none
  // `threads` may be null. Throws std::invalid_argument where sizes or types don't fit.
  void Select(const cv::Mat& uncertainty, const cv::Mat& disparity, const cv::Mat& right_winner,
              int min_disparity, double keep_quantile, ThreadPool* threads);

  // CV_8U: 255 where the pixel is confident, else 0.
  const cv::Mat& mask() const { return mask_; }

 private:
  cv::Mat mask_;
};

}  // namespace stereo_sgmp

#endif  // STEREO_SGMP_PRIOR_CONFIDENT_PIXELS_H_
