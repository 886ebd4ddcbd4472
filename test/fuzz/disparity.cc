// Disparity and depth maps: the first byte tells the format, the others are the file.
#include "io/disparity_file.h"

#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <limits>

#include "fuzz/expectations.h"

namespace stereo_sgmp {
namespace {

bool IsKnownOrInfinite(const cv::Mat& map) {
  return map.type() == CV_32FC1 && std::all_of(map.begin<float>(), map.end<float>(), [](float d) {
           return std::isfinite(d) || d == std::numeric_limits<float>::infinity();
         });
}

void ReadMap(std::uint8_t format, const std::string& bytes) {
  constexpr std::array<const char*, 2> kNames = {"a.pfm", "a.png"};
  constexpr std::array<double, 4> kScales = {0.0, 1.0, 256.0, 1e-300};
  const std::string name = kNames[format % 2];
  StereoCamera camera;
  camera.focal_length = 300.0;
  camera.baseline = 0.1;
  cv::Mat map;
  const bool is_map = Reads([&] {
    map = (format & 2) == 0 ? DecodeDisparity(bytes, name, kScales[format / 4 % 4])
                            : DecodeDepthAsDisparity(bytes, name, camera);
  });
  Expect(!is_map || IsKnownOrInfinite(map), "disparities or infinity");
}

}  // namespace
}  // namespace stereo_sgmp

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  if (size == 0) return 0;
  stereo_sgmp::ReadMap(data[0], std::string(reinterpret_cast<const char*>(data) + 1, size - 1));
  return 0;
}
