// Message fields made of the fuzzer's bytes.
#ifndef STEREO_SGMP_FUZZ_MESSAGES_H_
#define STEREO_SGMP_FUZZ_MESSAGES_H_

#include <cstdint>
#include <limits>
#include <string>

#include <fuzzer/FuzzedDataProvider.h>
#include <sensor_msgs/CameraInfo.h>
#include <sensor_msgs/Image.h>
#include <sensor_msgs/image_encodings.h>
#include <boost/make_shared.hpp>

namespace stereo_sgmp {

// Mostly small, now and then anything.
inline std::uint32_t ConsumeSize(FuzzedDataProvider* input) {
  const auto size = input->ConsumeIntegral<std::uint8_t>();
  return size < 240 ? size % 16 : input->ConsumeIntegral<std::uint32_t>();
}

inline std::string ConsumeEncoding(FuzzedDataProvider* input) {
  namespace enc = sensor_msgs::image_encodings;
  static const std::string kKnown[] = {
      enc::MONO8, enc::MONO16,      enc::BGR8,        enc::RGB8,       enc::BGRA8,
      enc::RGBA8, enc::BAYER_RGGB8, enc::TYPE_8UC1,   enc::TYPE_32FC1, enc::YUV422,
      enc::BGR16, enc::TYPE_16UC1,  enc::BAYER_BGGR16};
  if (input->ConsumeIntegral<std::uint8_t>() < 240) return input->PickValueInArray(kKnown);
  return input->ConsumeRandomLengthString();
}

// An image whose step and data fit its size, or not.
inline sensor_msgs::ImageConstPtr ConsumeImage(FuzzedDataProvider* input) {
  auto image = boost::make_shared<sensor_msgs::Image>();
  image->encoding = ConsumeEncoding(input);
  image->width = ConsumeSize(input);
  image->height = ConsumeSize(input);
  image->is_bigendian = input->ConsumeIntegral<std::uint8_t>();
  image->step = ConsumeSize(input);
  const bool fits = input->ConsumeBool();
  const std::uint64_t bytes = std::uint64_t{image->step} * image->height;
  constexpr std::uint64_t kLargest = 1 << 12;
  image->data.assign(fits && bytes < kLargest ? bytes : input->ConsumeIntegral<std::uint8_t>(),
                     input->ConsumeIntegral<std::uint8_t>());
  return image;
}

// A number of a calibration: usual, odd or any.
inline double ConsumeNumber(FuzzedDataProvider* input) {
  using Limits = std::numeric_limits<double>;
  static const double kOdd[] = {0.0,
                                -0.0,
                                1.0,
                                -30.0,
                                300.0,
                                301.0,
                                160.0,
                                Limits::infinity(),
                                -Limits::infinity(),
                                Limits::quiet_NaN(),
                                Limits::max(),
                                Limits::denorm_min(),
                                -Limits::denorm_min(),
                                1e160,
                                1e-160};
  if (input->ConsumeIntegral<std::uint8_t>() < 240) return input->PickValueInArray(kOdd);
  return input->ConsumeFloatingPoint<double>();
}

}  // namespace stereo_sgmp

#endif  // STEREO_SGMP_FUZZ_MESSAGES_H_
