#include "geometry/cloud_rows.h"

#include <algorithm>
#include <cstddef>
#include <limits>
#include <sstream>
#include <stdexcept>

namespace stereo_sgmp {
namespace {

void CheckImage(const MatchResult& result, const cv::Mat& image) {
  if (image.size() != result.dense.size()) {
    std::ostringstream message;
    message << "The image that colours the cloud has " << image.cols << " x " << image.rows
            << " pixels, but the disparity has " << result.dense.cols << " x " << result.dense.rows
            << "; take the left image that was matched.";
    throw std::invalid_argument(message.str());
  }
  const bool known_depth = image.depth() == CV_8U || image.depth() == CV_16U;
  const bool known_channels =
      image.channels() == 1 || image.channels() == 3 || image.channels() == 4;
  if (!known_depth || !known_channels) {
    std::ostringstream message;
    message << "The image that colours the cloud is of OpenCV type " << image.type()
            << ", but it has to be 8 or 16 bit, gray, BGR or BGRA; convert it.";
    throw std::invalid_argument(message.str());
  }
}

std::uint8_t ToByte(std::uint8_t value) { return value; }
std::uint8_t ToByte(std::uint16_t value) { return static_cast<std::uint8_t>(value >> 8); }

template <class T>
void ColorRow(const T* pixels, int channels, int width, CloudPoint* points) {
  const int green = channels == 1 ? 0 : 1;
  const int red = channels == 1 ? 0 : 2;
  for (int x = 0; x < width; ++x) {
    const T* pixel = pixels + x * channels;
    points[x].b = ToByte(pixel[0]);
    points[x].g = ToByte(pixel[green]);
    points[x].r = ToByte(pixel[red]);
    points[x].unused = 0;
  }
}

}  // namespace

CloudRows::CloudRows(const MatchResult& result, const StereoCamera& camera, const cv::Mat& image,
                     const CloudOptions& options)
    : result_(result),
      image_(image),
      focal_length_(static_cast<float>(camera.focal_length)),
      baseline_(static_cast<float>(camera.baseline)),
      cx_(static_cast<float>(camera.cx)),
      cy_(static_cast<float>(camera.cy)),
      doffs_(static_cast<float>(camera.doffs)),
      max_depth_(static_cast<float>(options.max_depth)),
      min_confidence_(static_cast<float>(options.min_confidence)) {
  camera.Check();
  CheckImage(result, image);
}

void CloudRows::Row(int y, CloudPoint* points) const {
  PlaceRow(y, points);
  if (image_.depth() == CV_8U) {
    ColorRow(image_.ptr<std::uint8_t>(y), image_.channels(), width(), points);
  } else {
    ColorRow(image_.ptr<std::uint16_t>(y), image_.channels(), width(), points);
  }
}

// All is computed for each pixel and chosen afterwards: branches would mispredict.
void CloudRows::PlaceRow(int y, CloudPoint* points) const {
  const float* const disparity = result_.dense.ptr<float>(y);
  const float* const confidence = result_.confidence.ptr<float>(y);
  const std::uint8_t* const reason = result_.reason.ptr<std::uint8_t>(y);
  const int columns = width();
  const float doffs = doffs_;
  const float baseline = baseline_;
  const float focal_length = focal_length_;
  const float max_depth = max_depth_;
  const float min_confidence = min_confidence_;
  const float cx = cx_;
  const float v = static_cast<float>(y) - cy_;
  for (int x = 0; x < columns; ++x) {
    const float shifted = disparity[x] + doffs;
    const float units_per_pixel = baseline / shifted;
    const float z = focal_length * units_per_pixel;
    const bool seen = (reason[x] == static_cast<std::uint8_t>(InvalidReason::kValid)) &
                      (confidence[x] >= min_confidence) & (shifted > 0.0f) &
                      (z <= std::min(max_depth, std::numeric_limits<float>::max()));
    const float scale = seen ? units_per_pixel : std::numeric_limits<float>::quiet_NaN();
    points[x].x = (static_cast<float>(x) - cx) * scale;
    points[x].y = v * scale;
    points[x].z = focal_length * scale;
    points[x].confidence = confidence[x];
  }
}

void ComputePointCloud(const MatchResult& result, const StereoCamera& camera, const cv::Mat& image,
                       const CloudOptions& options, PointCloud* cloud) {
  const CloudRows rows(result, camera, image, options);
  cloud->width = rows.width();
  cloud->height = rows.height();
  cloud->points.resize(result.dense.total());
  for (int y = 0; y < cloud->height; ++y) {
    rows.Row(y, cloud->points.data() +
                    static_cast<std::size_t>(y) * static_cast<std::size_t>(cloud->width));
  }
}

}  // namespace stereo_sgmp
