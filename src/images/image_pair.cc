#include "images/image_pair.h"

#include <algorithm>
#include <opencv2/imgproc.hpp>
#include <sstream>
#include <stdexcept>

namespace stereo_sgmp {
namespace {

void CheckImage(const cv::Mat& image, const char* side) {
  std::ostringstream text;
  if (image.empty()) {
    text << "the " << side << " image is empty; expected at least 1x1 pixels";
  } else if (image.dims != 2 || (image.depth() != CV_8U && image.depth() != CV_16U)) {
    text << "the " << side << " image has OpenCV depth " << image.depth()
         << "; expected 8 or 16 bit unsigned";
  } else if (image.channels() == 2 || image.channels() > 4) {
    text << "the " << side << " image has " << image.channels()
         << " channels; expected 1 (gray), 3 (BGR) or 4 (BGRA)";
  } else {
    return;
  }
  throw std::invalid_argument(text.str());
}

void CheckPair(const cv::Mat& left, const cv::Mat& right) {
  CheckImage(left, "left");
  CheckImage(right, "right");
  std::ostringstream text;
  if (left.size() != right.size()) {
    text << "the left image is " << left.cols << "x" << left.rows << " and the right " << right.cols
         << "x" << right.rows << "; expected one size, rectify both alike";
  } else if (left.type() != right.type()) {
    text << "the left image has OpenCV type " << left.type() << " and the right " << right.type()
         << "; expected one type";
  } else {
    return;
  }
  throw std::invalid_argument(text.str());
}

double LargestValue(const cv::Mat& image) {
  double largest = 0.0;
  cv::minMaxLoc(image.reshape(1), nullptr, &largest);
  return largest;
}

// 8-bit version of `image`; shares its data when it is one already.
void To8Bit(const cv::Mat& image, double scale, cv::Mat* out) {
  if (image.depth() == CV_8U) {
    *out = image;
    return;
  }
  image.convertTo(*out, CV_8U, scale);
}

void ToGray(const cv::Mat& image, cv::Mat* gray) {
  switch (image.channels()) {
    case 1:
      image.copyTo(*gray);
      break;
    case 3:
      cv::cvtColor(image, *gray, cv::COLOR_BGR2GRAY);
      break;
    default:
      cv::cvtColor(image, *gray, cv::COLOR_BGRA2GRAY);
  }
}

void ToColor(const cv::Mat& image, const cv::Mat& gray, cv::Mat* color) {
  if (image.channels() == 4) {
    cv::cvtColor(image, *color, cv::COLOR_BGRA2BGR);
  } else {
    *color = image.channels() == 3 ? image : gray;
  }
}

}  // namespace

void ImagePair::Prepare(const cv::Mat& left, const cv::Mat& right) {
  CheckPair(left, right);
  double scale = 1.0;
  if (left.depth() == CV_16U) {
    double largest = std::max(LargestValue(left), LargestValue(right));
    for (; largest > 255.0; largest /= 2.0) scale /= 2.0;
    left_8bit_.release();
    right_8bit_.release();
  }
  To8Bit(left, scale, &left_8bit_);
  To8Bit(right, scale, &right_8bit_);
  ToGray(left_8bit_, &left_gray_);
  ToGray(right_8bit_, &right_gray_);
  left_color_.release();
  ToColor(left_8bit_, left_gray_, &left_color_);
}

void ImagePair::Shrink(const ImagePair& full, cv::Size size, ThreadPool* pool) {
  shrinker_.Shrink(full.left_gray_, size, &left_gray_, pool);
  shrinker_.Shrink(full.right_gray_, size, &right_gray_, pool);
  if (full.left_color_.channels() == 1) {
    left_color_ = left_gray_;
    return;
  }
  if (left_color_.channels() == 1) left_color_.release();
  shrinker_.Shrink(full.left_color_, size, &left_color_, pool);
}

}  // namespace stereo_sgmp
