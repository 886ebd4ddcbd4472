#include "geometry/cloud_rows.h"

#include <cstddef>
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
