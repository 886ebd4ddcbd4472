#include "stereo_sgmp/point_cloud.h"

#include <cmath>
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

// What is the same for all points of a cloud, in the precision of its points.
struct Projection {
  Projection(const StereoCamera& camera, const CloudOptions& options)
      : focal_length(static_cast<float>(camera.focal_length)),
        baseline(static_cast<float>(camera.baseline)),
        cx(static_cast<float>(camera.cx)),
        cy(static_cast<float>(camera.cy)),
        doffs(static_cast<float>(camera.doffs)),
        max_depth(static_cast<float>(options.max_depth)),
        min_confidence(static_cast<float>(options.min_confidence)) {}

  float focal_length;
  float baseline;
  float cx;
  float cy;
  float doffs;
  float max_depth;
  float min_confidence;
};

void PlaceRow(const MatchResult& result, const Projection& projection, int y, CloudPoint* points) {
  const float* disparity = result.dense.ptr<float>(y);
  const float* confidence = result.confidence.ptr<float>(y);
  const std::uint8_t* reason = result.reason.ptr<std::uint8_t>(y);
  const float v = static_cast<float>(y) - projection.cy;
  for (int x = 0; x < result.dense.cols; ++x) {
    const float shifted = disparity[x] + projection.doffs;
    const float units_per_pixel = projection.baseline / shifted;
    const float z = projection.focal_length * units_per_pixel;
    const bool seen = reason[x] == static_cast<std::uint8_t>(InvalidReason::kValid) &&
                      confidence[x] >= projection.min_confidence && shifted > 0.0f &&
                      std::isfinite(z) && z <= projection.max_depth;
    const float scale = seen ? units_per_pixel : std::numeric_limits<float>::quiet_NaN();
    points[x].x = (static_cast<float>(x) - projection.cx) * scale;
    points[x].y = v * scale;
    points[x].z = projection.focal_length * scale;
    points[x].confidence = confidence[x];
  }
}

}  // namespace

void ComputePointCloud(const MatchResult& result, const StereoCamera& camera, const cv::Mat& image,
                       const CloudOptions& options, PointCloud* cloud) {
  camera.Check();
  CheckImage(result, image);
  cloud->width = result.dense.cols;
  cloud->height = result.dense.rows;
  cloud->points.resize(result.dense.total());
  const Projection projection(camera, options);
  for (int y = 0; y < cloud->height; ++y) {
    CloudPoint* points =
        cloud->points.data() + static_cast<std::size_t>(y) * static_cast<std::size_t>(cloud->width);
    PlaceRow(result, projection, y, points);
    if (image.depth() == CV_8U) {
      ColorRow(image.ptr<std::uint8_t>(y), image.channels(), cloud->width, points);
    } else {
      ColorRow(image.ptr<std::uint16_t>(y), image.channels(), cloud->width, points);
    }
  }
}

}  // namespace stereo_sgmp
