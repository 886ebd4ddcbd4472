#include "alignment/row_matches.h"

#include <algorithm>
#include <cmath>

#include <opencv2/imgproc.hpp>

#include "alignment/subpixel_match.h"
#include "alignment/template_search.h"

namespace stereo_sgmp {
namespace {

constexpr double kSearchPixels = 4e5;  // the search runs on images of about this size
constexpr double kMaxRowOffset = 8.0;  // pixels at full size ...
constexpr double kMaxRowShare = 0.01;  // ... or this share of the rows, if more
constexpr double kCornerQuality = 0.01;
constexpr double kCornerDistance = 6.0;

// Full size and halves of it, down to the scale of the search.
struct Pyramid {
  std::vector<cv::Mat> levels;

  explicit Pyramid(const cv::Mat& image) : levels{image} {
    while (static_cast<double>(levels.back().total()) > 1.5 * kSearchPixels) {
      cv::Mat half;
      const cv::Size size(levels.back().cols / 2, levels.back().rows / 2);
      cv::resize(levels.back(), half, size, 0.0, 0.0, cv::INTER_AREA);
      levels.push_back(half);
    }
  }
};

SearchRange RangeAtScale(const cv::Mat& image, int min_disparity, int num_disparities,
                         double factor) {
  const double rows = std::max(kMaxRowOffset, kMaxRowShare * image.rows);
  SearchRange range;
  range.min_disparity = static_cast<int>(std::floor(min_disparity / factor)) - 1;
  range.max_disparity = static_cast<int>(std::ceil((min_disparity + num_disparities) / factor)) + 1;
  range.rows = static_cast<int>(std::ceil(rows / factor));
  return range;
}

// Carries a match from the scale of the search to full size, refined on each level.
bool RefineThroughLevels(const Pyramid& left, const Pyramid& right, cv::Point point,
                         cv::Point found, RowMatch* match) {
  const auto level_count = left.levels.size();
  cv::Point2d refined = found;
  for (std::size_t level = level_count; level-- > 0;) {
    if (level + 1 < level_count) {
      // A pixel c covers 2 c and 2 c + 1 of the next level. The half pixel by which 2 c is off
      // its centre is the same in both images.
      refined *= 2.0;
      point *= 2;
    }
    if (!RefineMatch(left.levels[level], right.levels[level], point, &refined)) return false;
  }
  *match = {static_cast<double>(point.y), refined.y};
  return true;
}

}  // namespace

std::vector<RowMatch> FindRowMatches(const cv::Mat& left, const cv::Mat& right, int min_disparity,
                                     int num_disparities, int max_corners) {
  std::vector<RowMatch> matches;
  if (std::min(left.cols, left.rows) <= 2 * TemplateSearch::kRadius) return matches;
  const Pyramid left_levels(left);
  const Pyramid right_levels(right);
  const cv::Mat& small_left = left_levels.levels.back();
  const double factor = std::ldexp(1.0, static_cast<int>(left_levels.levels.size()) - 1);
  const SearchRange range = RangeAtScale(left, min_disparity, num_disparities, factor);

  std::vector<cv::Point2f> corners;
  cv::goodFeaturesToTrack(small_left, corners, max_corners, kCornerQuality, kCornerDistance);
  TemplateSearch search(small_left, right_levels.levels.back(), range);
  for (const cv::Point2f& corner : corners) {
    const cv::Point point(corner);
    cv::Point found;
    RowMatch match;
    if (search.Find(point, &found) &&
        RefineThroughLevels(left_levels, right_levels, point, found, &match)) {
      matches.push_back(match);
    }
  }
  return matches;
}

}  // namespace stereo_sgmp
