#include "matcher/camera_order.h"

#include <algorithm>
#include <cmath>

#include <opencv2/imgproc.hpp>

#include "stereo_sgmp/matcher.h"

namespace stereo_sgmp {
namespace {

constexpr int kWidth = 240;  // of the images that are compared
constexpr int kFewestDisparities = 16;
// Share of the pixels whose left and right disparities agree: of an exchanged pair it is what
// chance and repeated texture give, of a good one most of the image.
constexpr double kGood = 0.4;
constexpr double kTimesBetter = 2.0;

double Agreement(const cv::Mat& left, const cv::Mat& right, const Options& options) {
  MatchResult result;
  Matcher(options).Match(left, right, &result);
  return result.statistics.density;
}

}  // namespace

bool LookSwapped(const cv::Mat& left, const cv::Mat& right, const Options& options) {
  const double scale = std::min(1.0, static_cast<double>(kWidth) / left.cols);
  cv::Mat small_left;
  cv::Mat small_right;
  cv::resize(left, small_left, cv::Size(), scale, scale, cv::INTER_AREA);
  cv::resize(right, small_right, cv::Size(), scale, scale, cv::INTER_AREA);

  Options small;
  small.threads = options.threads;
  small.min_disparity = static_cast<int>(std::floor(options.min_disparity * scale));
  small.num_disparities =
      std::clamp(static_cast<int>(std::ceil(options.num_disparities * scale)),
                 std::min(kFewestDisparities, small_left.cols), small_left.cols);
  small.alignment.mode = AlignmentMode::kOff;
  small.prior.variant = Variant::kSgm;
  small.filter.lr_tolerance = 1.0;
  const double as_given = Agreement(small_left, small_right, small);
  const double exchanged = Agreement(small_right, small_left, small);
  return exchanged > kGood && exchanged > kTimesBetter * as_given;
}

}  // namespace stereo_sgmp
