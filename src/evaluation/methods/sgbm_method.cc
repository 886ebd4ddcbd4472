#include "evaluation/methods/sgbm_method.h"

#include <algorithm>
#include <array>
#include <chrono>
#include <limits>
#include <stdexcept>
#include <utility>

#include <opencv2/calib3d.hpp>
#include <opencv2/imgproc.hpp>

#include "evaluation/methods/sparse_result.h"
#include "io/image.h"

namespace stereo_sgmp {
namespace {

constexpr std::array<std::pair<const char*, int>, 3> kModes{
    {{"sgbm", cv::StereoSGBM::MODE_SGBM},
     {"sgbm_3way", cv::StereoSGBM::MODE_SGBM_3WAY},
     {"hh", cv::StereoSGBM::MODE_HH}}};

int ModeOf(const std::string& name) {
  for (const auto& [mode_name, mode] : kModes) {
    if (name == mode_name) return mode;
  }
  throw std::invalid_argument("There is no mode " + name + " of StereoSGBM; expected are sgbm, " +
                              "sgbm_3way and hh.");
}

// StereoSGBM takes 8 bit, gray or BGR.
cv::Mat ToSgbmInput(const cv::Mat& image) {
  cv::Mat converted = To8Bit(image);
  if (converted.channels() == 4) cv::cvtColor(converted, converted, cv::COLOR_BGRA2BGR);
  return converted;
}

cv::Ptr<cv::StereoSGBM> MakeMatcher(int mode, int min_disparity, int num_disparities,
                                    int channels) {
  constexpr int kBlock = 5;
  constexpr int kLeftRight = 1;  // pixels
  constexpr int kPreFilterCap = 63;
  constexpr int kUniqueness = 10;  // percent
  constexpr int kSpeckleSize = 100;
  constexpr int kSpeckleRange = 2;  // pixels
  constexpr int kMultiple = 16;     // the number of disparities must be one of it
  const int values = kBlock * kBlock * channels;
  const int rounded = (num_disparities + kMultiple - 1) / kMultiple * kMultiple;
  return cv::StereoSGBM::create(min_disparity, rounded, kBlock, 8 * values, 32 * values, kLeftRight,
                                kPreFilterCap, kUniqueness, kSpeckleSize, kSpeckleRange, mode);
}

// The image with so many columns more on its left.
cv::Mat WithMargin(const cv::Mat& image, int columns) {
  cv::Mat wider;
  cv::copyMakeBorder(image, wider, 0, 0, columns, 0, cv::BORDER_REPLICATE);
  return wider;
}

// In 1/16 pixels. StereoSGBM leaves out the columns for which not all disparities lie inside of
// the right image; the margin makes it match those of the image too.
cv::Mat Compute(const cv::Ptr<cv::StereoSGBM>& matcher, const cv::Mat& left, const cv::Mat& right) {
  const int margin = std::max(matcher->getMinDisparity() + matcher->getNumDisparities(), 0);
  cv::Mat disparity;
  matcher->compute(WithMargin(left, margin), WithMargin(right, margin), disparity);
  return disparity.colRange(margin, disparity.cols);
}

cv::Mat ToDisparity(const cv::Mat& fixed_point, int min_disparity) {
  constexpr double kUnit = 1.0 / cv::StereoMatcher::DISP_SCALE;
  cv::Mat disparity;
  fixed_point.convertTo(disparity, CV_32F, kUnit);
  disparity.setTo(std::numeric_limits<float>::infinity(), disparity < min_disparity);
  return disparity;
}

// Sets OpenCV's number of threads for as long as it lives.
class OpenCvThreads {
 public:
  explicit OpenCvThreads(int threads) : before_(cv::getNumThreads()) {
    if (threads > 0) cv::setNumThreads(threads);
  }
  ~OpenCvThreads() { cv::setNumThreads(before_); }
  OpenCvThreads(const OpenCvThreads&) = delete;
  OpenCvThreads& operator=(const OpenCvThreads&) = delete;

 private:
  int before_;
};

}  // namespace

std::vector<std::string> SgbmMethod::Names() {
  std::vector<std::string> names;
  for (const auto& mode : kModes) names.emplace_back(mode.first);
  return names;
}

SgbmMethod::SgbmMethod(const std::string& name, int min_disparity, int threads)
    : StereoMethod(name), mode_(ModeOf(name)), min_disparity_(min_disparity), threads_(threads) {}

MethodResult SgbmMethod::Run(const StereoScene& scene, int num_disparities) {
  const OpenCvThreads threads(threads_);
  const auto start = std::chrono::steady_clock::now();
  const cv::Mat left = ToSgbmInput(scene.left);
  const cv::Mat right = ToSgbmInput(scene.right);
  const cv::Mat fixed_point =
      Compute(MakeMatcher(mode_, min_disparity_, num_disparities, left.channels()), left, right);
  const std::chrono::duration<double> elapsed = std::chrono::steady_clock::now() - start;
  MethodResult result = SparseResult(ToDisparity(fixed_point, min_disparity_));
  result.seconds = elapsed.count();
  return result;
}

}  // namespace stereo_sgmp
