#include "io/normals_file.h"

#include <cmath>
#include <sstream>
#include <stdexcept>

#include "io/file_io.h"
#include "io/pfm.h"

namespace stereo_sgmp {
namespace {

// By which the length of a unit vector may differ from 1; files that store the components as
// colours, or not normalised, miss it by far.
constexpr double kTolerance = 0.02;

[[noreturn]] void FailAt(const std::string& path, int x, int y, double length) {
  std::ostringstream message;
  message
      << path << ": the normal at x " << x << ", y " << y << " has length " << length
      << ", but unit vectors are expected (x right, y down, z forward), zero or NaN where there "
      << "is none.";
  throw std::invalid_argument(message.str());
}

}  // namespace

cv::Mat DecodeNormals(const std::string& bytes, const std::string& name) {
  cv::Mat normals = DecodePfm(bytes, name);
  if (normals.channels() != 3) {
    throw std::invalid_argument(name +
                                ": one channel found, three (\"PF\") are expected of normals.");
  }
  for (int y = 0; y < normals.rows; ++y) {
    for (int x = 0; x < normals.cols; ++x) {
      cv::Vec3f& normal = normals.at<cv::Vec3f>(y, x);
      const double length = cv::norm(normal);
      if (!std::isfinite(length)) {
        normal = cv::Vec3f::all(0.0f);
      } else if (length > 0.0 && std::abs(length - 1.0) > kTolerance) {
        FailAt(name, x, y, length);
      }
    }
  }
  return normals;
}

cv::Mat ReadNormals(const std::string& path) { return DecodeNormals(ReadFile(path), path); }

}  // namespace stereo_sgmp
