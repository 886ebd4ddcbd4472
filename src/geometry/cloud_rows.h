#ifndef STEREO_SGMP_GEOMETRY_CLOUD_ROWS_H_
#define STEREO_SGMP_GEOMETRY_CLOUD_ROWS_H_

#include <algorithm>
#include <cstdint>
#include <limits>

#include <opencv2/core.hpp>

#include "stereo_sgmp/match_result.h"
#include "stereo_sgmp/point_cloud.h"
#include "stereo_sgmp/stereo_camera.h"

namespace stereo_sgmp {

// The points of ComputePointCloud a row at a time, for who wants them elsewhere. Result and image
// have to outlive it.
class CloudRows {
 public:
  // Throws as ComputePointCloud.
  CloudRows(const MatchResult& result, const StereoCamera& camera, const cv::Mat& image,
            const CloudOptions& options);

  int width() const { return result_.dense.cols; }
  int height() const { return result_.dense.rows; }

  // `points` has room for width(). A Point has the fields of CloudPoint, and no others are set.
  template <class Point>
  void Row(int y, Point* points) const {
    PlaceRow(y, points);
    if (image_.depth() == CV_8U) {
      ColorRow(image_.ptr<std::uint8_t>(y), points);
    } else {
      ColorRow(image_.ptr<std::uint16_t>(y), points);
    }
  }

 private:
  static std::uint8_t ToByte(std::uint8_t value) { return value; }
  static std::uint8_t ToByte(std::uint16_t value) { return static_cast<std::uint8_t>(value >> 8); }

  template <class Point>
  void PlaceRow(int y, Point* points) const;
  template <class T, class Point>
  void ColorRow(const T* pixels, Point* points) const;

  const MatchResult& result_;
  const cv::Mat image_;
  // In the precision of the points.
  const float focal_length_;
  const float baseline_;
  const float cx_;
  const float cy_;
  const float doffs_;
  const float max_depth_;
  const float min_confidence_;
};

// All is computed for each pixel and chosen afterwards: branches would mispredict.
template <class Point>
void CloudRows::PlaceRow(int y, Point* points) const {
  const float* const disparity = result_.dense.ptr<float>(y);
  const float* const confidence = result_.confidence.ptr<float>(y);
  const std::uint8_t* const reason = result_.reason.ptr<std::uint8_t>(y);
  // Kept here, since points that are stored could change them for all that the compiler knows.
  const int columns = width();
  const float doffs = doffs_;
  const float baseline = baseline_;
  const float focal_length = focal_length_;
  const float max_depth = std::min(max_depth_, std::numeric_limits<float>::max());
  const float min_confidence = min_confidence_;
  const float cx = cx_;
  const float v = static_cast<float>(y) - cy_;
  for (int x = 0; x < columns; ++x) {
    const float shifted = disparity[x] + doffs;
    const float units_per_pixel = baseline / shifted;
    const float z = focal_length * units_per_pixel;
    const bool seen = (reason[x] == static_cast<std::uint8_t>(InvalidReason::kValid)) &
                      (confidence[x] >= min_confidence) & (shifted > 0.0f) & (z <= max_depth);
    const float scale = seen ? units_per_pixel : std::numeric_limits<float>::quiet_NaN();
    points[x].x = (static_cast<float>(x) - cx) * scale;
    points[x].y = v * scale;
    points[x].z = focal_length * scale;
    points[x].confidence = confidence[x];
  }
}

template <class T, class Point>
void CloudRows::ColorRow(const T* pixels, Point* points) const {
  const int channels = image_.channels();
  const int columns = width();
  const int green = channels == 1 ? 0 : 1;
  const int red = channels == 1 ? 0 : 2;
  for (int x = 0; x < columns; ++x, pixels += channels) {
    points[x].b = ToByte(pixels[0]);
    points[x].g = ToByte(pixels[green]);
    points[x].r = ToByte(pixels[red]);
    points[x].unused = 0;
  }
}

}  // namespace stereo_sgmp

#endif  // STEREO_SGMP_GEOMETRY_CLOUD_ROWS_H_
