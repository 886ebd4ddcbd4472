// calib.txt.
#include "io/calib.h"

#include <cstddef>
#include <cstdint>

#include "fuzz/expectations.h"

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  const std::string text(reinterpret_cast<const char*>(data), size);
  stereo_sgmp::Calibration calibration;
  if (stereo_sgmp::Reads([&] { calibration = stereo_sgmp::ParseCalibration(text, "calib.txt"); })) {
    calibration.camera.Check();
    stereo_sgmp::Expect(calibration.size.width >= 0 && calibration.size.height >= 0, "a size");
    stereo_sgmp::Expect(calibration.num_disparities >= 0, "a number of disparities");
  }
  return 0;
}
