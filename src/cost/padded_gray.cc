#include "cost/padded_gray.h"

namespace stereo_sgmp {

void PaddedGray::Assign(const cv::Mat& gray, Orientation orientation) {
  orientation_ = orientation;
  width_ = gray.cols;
  height_ = gray.rows;
  if (orientation == Orientation::kMirrored) cv::flip(gray, mirrored_, 1);
  const cv::Mat& source = orientation == Orientation::kMirrored ? mirrored_ : gray;
  cv::copyMakeBorder(source, padded_, kBorder, kBorder, kBorder, kBorder + kOverrun,
                     cv::BORDER_REPLICATE | cv::BORDER_ISOLATED);
}

}  // namespace stereo_sgmp
