#ifndef STEREO_SGMP_IMAGES_IMAGE_PAIR_H_
#define STEREO_SGMP_IMAGES_IMAGE_PAIR_H_

#include <opencv2/core.hpp>

#include "common/thread_pool.h"
#include "images/area_shrinker.h"

namespace stereo_sgmp {

// A stereo pair in the forms that matching works on. Buffers are kept between frames.
class ImagePair {
 public:
  // Takes 8 or 16 bit, gray, BGR or BGRA. 16-bit images lose as many low bits, the same for both,
  // as the largest value of the pair has above eight. Throws std::invalid_argument unless both
  // images are of such a type and of one size and type, and not empty.
  void Prepare(const cv::Mat& left, const cv::Mat& right);

  // Area-averaged to `size`, for the coarse pass.
  void Shrink(const ImagePair& full, cv::Size size, ThreadPool* pool);

  cv::Size size() const { return left_gray_.size(); }
  const cv::Mat& left_gray() const { return left_gray_; }    // CV_8UC1
  const cv::Mat& right_gray() const { return right_gray_; }  // CV_8UC1
  cv::Mat& right_gray() { return right_gray_; }
  // CV_8UC3 of a colour pair, else the gray image.
  const cv::Mat& left_color() const { return left_color_; }

 private:
  cv::Mat left_gray_;
  cv::Mat right_gray_;
  cv::Mat left_color_;
  cv::Mat left_8bit_;
  cv::Mat right_8bit_;
  AreaShrinker shrinker_;
};

}  // namespace stereo_sgmp

#endif  // STEREO_SGMP_IMAGES_IMAGE_PAIR_H_
