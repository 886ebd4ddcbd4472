// Normal maps.
#include "io/normals_file.h"

#include <cmath>
#include <cstddef>
#include <cstdint>

#include "fuzz/expectations.h"

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  const std::string bytes(reinterpret_cast<const char*>(data), size);
  cv::Mat normals;
  if (stereo_sgmp::Reads([&] { normals = stereo_sgmp::DecodeNormals(bytes, "normals.pfm"); })) {
    stereo_sgmp::Expect(normals.type() == CV_32FC3, "three floats a pixel");
    for (auto normal = normals.begin<cv::Vec3f>(); normal != normals.end<cv::Vec3f>(); ++normal) {
      const double length = cv::norm(*normal);
      stereo_sgmp::Expect(length == 0.0 || std::abs(length - 1.0) < 0.1, "unit vectors");
    }
  }
  return 0;
}
