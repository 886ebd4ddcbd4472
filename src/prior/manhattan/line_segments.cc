#include "prior/manhattan/line_segments.h"

#include <algorithm>
#include <cmath>
#include <stdexcept>
#include <string>

#include <opencv2/imgproc.hpp>

namespace stereo_sgmp {
namespace {

// Pixels that lines are looked for in.
constexpr double kMaxPixels = 0.75e6;
// Shorter segments have too uncertain a direction, share of the diagonal.
constexpr double kMinLength = 0.02;

cv::Mat ToGray(const cv::Mat& image) {
  if (image.empty() || image.depth() != CV_8U || image.channels() == 2 || image.channels() > 4) {
    throw std::invalid_argument(
        "Line segments need a CV_8U image with 1, 3 or 4 channels that is not empty; convert it "
        "first.");
  }
  cv::Mat gray = image;
  if (image.channels() == 3) cv::cvtColor(image, gray, cv::COLOR_BGR2GRAY);
  if (image.channels() == 4) cv::cvtColor(image, gray, cv::COLOR_BGRA2GRAY);
  return gray;
}

cv::Mat Reduced(const cv::Mat& gray) {
  const double shrink = std::sqrt(kMaxPixels / static_cast<double>(gray.total()));
  if (shrink >= 1.0) return gray;
  cv::Mat small;
  cv::resize(gray, small, cv::Size(), shrink, shrink, cv::INTER_AREA);
  return small;
}

std::vector<cv::Vec4f> Detect(const cv::Mat& gray) {
  std::vector<cv::Vec4f> lines;
  try {
    cv::createLineSegmentDetector(cv::LSD_REFINE_STD)->detect(gray, lines);
  } catch (const cv::Exception& error) {
    throw std::runtime_error(
        std::string("OpenCV ") + CV_VERSION +
        " has no line segment detector, which Manhattan-world priors need; use OpenCV 4.5.1 or "
        "later, or another prior (OpenCV says: " +
        error.err + ").");
  }
  return lines;
}

}  // namespace

std::vector<LineSegment> FindLineSegments(const cv::Mat& image) {
  const cv::Mat gray = Reduced(ToGray(image));
  const double scale_x = static_cast<double>(image.cols) / gray.cols;
  const double scale_y = static_cast<double>(image.rows) / gray.rows;
  const auto to_image = [scale_x, scale_y](float x, float y) {
    return Eigen::Vector2d((x + 0.5) * scale_x - 0.5, (y + 0.5) * scale_y - 0.5);
  };
  const double min_length = kMinLength * std::hypot(image.cols, image.rows);
  std::vector<LineSegment> segments;
  for (const cv::Vec4f& line : Detect(gray)) {
    const LineSegment segment{to_image(line[0], line[1]), to_image(line[2], line[3])};
    if (segment.Length() >= min_length) segments.push_back(segment);
  }
  std::stable_sort(
      segments.begin(), segments.end(),
      [](const LineSegment& l, const LineSegment& r) { return l.Length() > r.Length(); });
  return segments;
}

}  // namespace stereo_sgmp
