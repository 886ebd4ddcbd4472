#include "io/disparity_file.h"

#include <algorithm>
#include <cctype>
#include <cmath>
#include <filesystem>
#include <limits>
#include <sstream>
#include <stdexcept>

#include "io/file_io.h"
#include "io/image.h"
#include "io/pfm.h"

namespace stereo_sgmp {
namespace {

constexpr float kUnknown = std::numeric_limits<float>::infinity();
constexpr double kKittiScale = 256.0;
constexpr double kMillimetresPerMetre = 1000.0;

bool IsPfmName(const std::string& path) {
  std::string extension = std::filesystem::path(path).extension().string();
  std::transform(extension.begin(), extension.end(), extension.begin(),
                 [](unsigned char c) { return static_cast<char>(std::tolower(c)); });
  return extension == ".pfm";
}

// One channel of floats, or of 8 or 16 bit, as stored.
cv::Mat DecodeMap(const std::string& bytes, const std::string& name) {
  cv::Mat map = IsPfmName(name) ? DecodePfm(bytes, name) : DecodeImage(bytes, name);
  if (map.channels() != 1) {
    throw std::invalid_argument(name + ": " + std::to_string(map.channels()) +
                                " channels found, one is expected of disparities and depths.");
  }
  return map;
}

void CheckScale(const std::string& name, double scale) {
  if (scale >= 0.0 && std::isfinite(scale)) return;
  std::ostringstream message;
  message << name << ": the scale of its disparities is " << scale
          << ", a number above 0 is expected (disparity = value / scale), or 0 for the format's.";
  throw std::invalid_argument(message.str());
}

double DefaultScale(const cv::Mat& map) { return map.depth() == CV_16U ? kKittiScale : 1.0; }

// Applies `convert`, a double of a double that may return what is not finite, to each known value.
template <class Convert>
cv::Mat Converted(const cv::Mat& map, const Convert& convert) {
  const bool zero_is_unknown = map.depth() != CV_32F;
  cv::Mat converted;
  map.convertTo(converted, CV_32F);
  converted.forEach<float>([&](float& value, const int* /*position*/) {
    const bool known = std::isfinite(value) && !(zero_is_unknown && value == 0.0f);
    const float result = known ? static_cast<float>(convert(static_cast<double>(value))) : kUnknown;
    value = std::isfinite(result) ? result : kUnknown;
  });
  return converted;
}

}  // namespace

cv::Mat DecodeDisparity(const std::string& bytes, const std::string& name, double scale) {
  CheckScale(name, scale);
  const cv::Mat map = DecodeMap(bytes, name);
  const double divisor = scale > 0.0 ? scale : DefaultScale(map);
  return Converted(map, [&](double value) { return value / divisor; });
}

cv::Mat DecodeDepthAsDisparity(const std::string& bytes, const std::string& name,
                               const StereoCamera& camera) {
  camera.Check();
  const cv::Mat map = DecodeMap(bytes, name);
  if (map.depth() == CV_8U) {
    throw std::invalid_argument(name + ": 8 bit are too coarse for depths; a .pfm file of metres " +
                                "or a 16-bit picture of millimetres is expected.");
  }
  const double units_per_metre = map.depth() == CV_16U ? kMillimetresPerMetre : 1.0;
  return Converted(map, [&](double value) {
    const double depth = value / units_per_metre;
    return depth > 0.0 ? camera.DisparityOf(depth) : static_cast<double>(kUnknown);
  });
}

cv::Mat ReadDisparity(const std::string& path, double scale) {
  return DecodeDisparity(ReadFile(path), path, scale);
}

cv::Mat ReadDepthAsDisparity(const std::string& path, const StereoCamera& camera) {
  return DecodeDepthAsDisparity(ReadFile(path), path, camera);
}

}  // namespace stereo_sgmp
