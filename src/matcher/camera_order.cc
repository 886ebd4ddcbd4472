#include "matcher/camera_order.h"

#include <algorithm>
#include <cmath>

#include <opencv2/imgproc.hpp>

#include "stereo_sgmp/matcher.h"

namespace stereo_sgmp {
namespace {

constexpr int kWidth = 240;  // of the images that are compared
constexpr int kFewestDisparities = 16;
constexpr int kTile = 12;  // pixels
// Shares of the pixels of a tile that match, by which one order has to surpass the other.
constexpr double kMargin = 0.15;
// Repeated texture matches in both orders by chance: for some tiles one is better, for some the
// other. Noise and stains, which do not repeat, let the true order win nearly all of them.
constexpr double kFewestTiles = 0.3;  // share for the exchanged order
constexpr int kTimesMore = 3;         // than for the order given

struct Votes {
  int as_given = 0;
  int exchanged = 0;
  int tiles = 0;
};

// Twice the range of the disparities: a repeated texture nearer than the range shall find its
// match, rather than one by chance in the other order.
Options SmallOptions(const Options& options, double scale, int width) {
  const int last = options.min_disparity + options.num_disparities;
  Options small;
  small.threads = options.threads;
  small.min_disparity = std::min(0, static_cast<int>(std::floor(options.min_disparity * scale)));
  const int asked = static_cast<int>(std::ceil(last * scale)) - small.min_disparity;
  const int wider = std::max(asked, std::min(2 * asked, width / 3));
  small.num_disparities = std::clamp(wider, std::min(kFewestDisparities, width), width);
  small.alignment.mode = AlignmentMode::kOff;
  small.prior.variant = Variant::kSgm;
  small.filter.lr_tolerance = 1.0;
  return small;
}

// 255 for the pixels of the left image whose match agrees with that of the right image.
cv::Mat Agreeing(const cv::Mat& left, const cv::Mat& right, const Options& options) {
  MatchResult result;
  Matcher(options).Match(left, right, &result);
  return result.reason == static_cast<int>(InvalidReason::kValid);
}

// Of the same pixels, in the exchanged order: seen in a mirror, what the left camera sees further
// to the left is what a left camera sees further to the right.
cv::Mat AgreeingExchanged(const cv::Mat& left, const cv::Mat& right, const Options& options) {
  constexpr int kAroundVertical = 1;
  cv::Mat mirrored_left;
  cv::Mat mirrored_right;
  cv::flip(left, mirrored_left, kAroundVertical);
  cv::flip(right, mirrored_right, kAroundVertical);
  cv::Mat agreeing;
  cv::flip(Agreeing(mirrored_left, mirrored_right, options), agreeing, kAroundVertical);
  return agreeing;
}

// Tiles near the sides are left out: their matches may lie outside the image in one of the orders.
Votes CompareTiles(const cv::Mat& as_given, const cv::Mat& exchanged, int margin) {
  Votes votes;
  for (int y = 0; y + kTile <= as_given.rows; y += kTile) {
    for (int x = margin; x + kTile <= as_given.cols - margin; x += kTile) {
      const cv::Rect tile(x, y, kTile, kTile);
      const double difference = (cv::mean(exchanged(tile))[0] - cv::mean(as_given(tile))[0]) / 255;
      ++votes.tiles;
      if (difference > kMargin) ++votes.exchanged;
      if (difference < -kMargin) ++votes.as_given;
    }
  }
  return votes;
}

}  // namespace

bool LookSwapped(const cv::Mat& left, const cv::Mat& right, const Options& options) {
  const double scale = std::min(1.0, static_cast<double>(kWidth) / left.cols);
  cv::Mat small_left;
  cv::Mat small_right;
  cv::resize(left, small_left, cv::Size(), scale, scale, cv::INTER_AREA);
  cv::resize(right, small_right, cv::Size(), scale, scale, cv::INTER_AREA);

  const Options small = SmallOptions(options, scale, small_left.cols);
  const int margin = std::min(small.num_disparities, small_left.cols / 4);
  const Votes votes = CompareTiles(Agreeing(small_left, small_right, small),
                                   AgreeingExchanged(small_left, small_right, small), margin);
  return votes.exchanged > kFewestTiles * votes.tiles &&
         votes.exchanged > kTimesMore * votes.as_given;
}

}  // namespace stereo_sgmp
