// PFM files.
#include "io/pfm.h"

#include <cstddef>
#include <cstdint>

#include "fuzz/expectations.h"

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  const std::string bytes(reinterpret_cast<const char*>(data), size);
  cv::Mat image;
  if (stereo_sgmp::Reads([&] { image = stereo_sgmp::DecodePfm(bytes, "a.pfm"); })) {
    stereo_sgmp::Expect(!image.empty() && image.depth() == CV_32F, "floats");
    stereo_sgmp::Expect(image.total() * image.elemSize() < size, "no more than was there");
  }
  return 0;
}
