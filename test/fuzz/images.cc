// Image messages of both cameras.
#include <cstddef>
#include <cstdint>

#include "fuzz/expectations.h"
#include "fuzz/messages.h"
#include "ros/input_images.h"

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  using namespace stereo_sgmp;
  FuzzedDataProvider input(data, size);
  const sensor_msgs::ImageConstPtr left = ConsumeImage(&input);
  const sensor_msgs::ImageConstPtr right = input.ConsumeBool() ? left : ConsumeImage(&input);
  InputPair pair;
  if (Reads([&] { pair = ToInputPair(left, right); })) {
    const cv::Mat& image = pair.left->image;
    Expect(!image.empty() && image.size() == pair.right->image.size(), "a pair of one size");
    Expect(image.type() == pair.right->image.type(), "a pair of one type");
    Expect(image.depth() == CV_8U || image.depth() == CV_16U, "8 or 16 bit");
    Expect(image.channels() != 2, "gray, BGR or BGRA");
    Expect(cv::sum(image)[0] >= 0.0 && cv::sum(pair.right->image)[0] >= 0.0, "pixels to read");
  }
  return 0;
}
