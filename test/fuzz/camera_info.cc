// CameraInfo messages of both cameras.
#include <cmath>
#include <cstddef>
#include <cstdint>

#include "fuzz/expectations.h"
#include "fuzz/messages.h"
#include "ros/camera_model.h"

namespace stereo_sgmp {
namespace {

sensor_msgs::CameraInfo ConsumeInfo(FuzzedDataProvider* input) {
  sensor_msgs::CameraInfo info;
  info.width = ConsumeSize(input);
  info.height = ConsumeSize(input);
  if (input->ConsumeBool()) {
    info.roi.width = ConsumeSize(input);
    info.roi.height = ConsumeSize(input);
    info.roi.x_offset = ConsumeSize(input);
    info.roi.y_offset = ConsumeSize(input);
    info.binning_x = ConsumeSize(input);
    info.binning_y = ConsumeSize(input);
  }
  for (double& entry : info.P) entry = ConsumeNumber(input);
  if (input->ConsumeBool()) info.P[5] = info.P[0];
  info.header.frame_id = input->ConsumeRandomLengthString();
  return info;
}

}  // namespace
}  // namespace stereo_sgmp

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  using namespace stereo_sgmp;
  FuzzedDataProvider input(data, size);
  const sensor_msgs::CameraInfo left = ConsumeInfo(&input);
  sensor_msgs::CameraInfo right = ConsumeInfo(&input);
  if (input.ConsumeBool()) {
    const double offset = right.P[3];
    right = left;
    right.P[3] = offset;
  }
  const cv::Size image_size(input.ConsumeIntegralInRange(1, 16),
                            input.ConsumeIntegralInRange(1, 16));
  StereoCamera camera;
  if (Reads([&] { camera = CameraFromInfo(left, right, image_size); })) camera.Check();
  const std::string problem = FrameIdProblem(left, right);
  if (!problem.empty()) ExpectReadable(problem);
  return 0;
}
