// Messages of the four input topics in any order, with any stamps.
#include "ros/synchronizer.h"

#include <cstddef>
#include <cstdint>

#include <fuzzer/FuzzedDataProvider.h>
#include <ros/console.h>
#include <boost/make_shared.hpp>

#include "fuzz/expectations.h"

namespace stereo_sgmp {
namespace {

// The time of the message before and a little more, or any.
ros::Time ConsumeStamp(FuzzedDataProvider* input, ros::Time* last) {
  const auto step = input->ConsumeIntegral<std::uint8_t>();
  if (step < 240) {
    last->nsec += step % 16;
  } else {
    last->sec = input->ConsumeIntegral<std::uint32_t>();
    last->nsec = input->ConsumeIntegral<std::uint32_t>();
  }
  return *last;
}

template <class Message>
boost::shared_ptr<Message> Stamped(const ros::Time& stamp) {
  auto message = boost::make_shared<Message>();
  message->header.stamp = stamp;
  return message;
}

void Add(StereoSynchronizer* synchronizer, int topic, const ros::Time& stamp) {
  switch (topic) {
    case 0:
      return synchronizer->AddLeftImage(Stamped<sensor_msgs::Image>(stamp));
    case 1:
      return synchronizer->AddLeftInfo(Stamped<sensor_msgs::CameraInfo>(stamp));
    case 2:
      return synchronizer->AddRightImage(Stamped<sensor_msgs::Image>(stamp));
    case 3:
      return synchronizer->AddRightInfo(Stamped<sensor_msgs::CameraInfo>(stamp));
    default:
      for (int each = 0; each < 4; ++each) Add(synchronizer, each, stamp);
  }
}

StereoSynchronizer::Settings ConsumeSettings(FuzzedDataProvider* input) {
  StereoSynchronizer::Settings settings;
  settings.queue_size = input->ConsumeIntegralInRange(1, 6);
  settings.approximate = input->ConsumeBool();
  if (input->ConsumeBool()) settings.max_interval = 1e-9 * input->ConsumeIntegral<std::uint8_t>();
  return settings;
}

}  // namespace
}  // namespace stereo_sgmp

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  using namespace stereo_sgmp;
  static const bool quiet =
      ros::console::set_logger_level(ROSCONSOLE_DEFAULT_NAME, ros::console::levels::Fatal);
  static_cast<void>(quiet);
  ros::Time::init();
  FuzzedDataProvider input(data, size);
  const StereoSynchronizer::Settings settings = ConsumeSettings(&input);
  const auto check_frame = [&](const StereoFrame& frame) {
    const ros::Time& stamp = frame.left->header.stamp;
    const bool equal = stamp == frame.right->header.stamp &&
                       stamp == frame.left_info->header.stamp &&
                       stamp == frame.right_info->header.stamp;
    Expect(equal || settings.approximate, "one stamp in a frame");
  };
  StereoSynchronizer synchronizer(
      settings, check_frame,
      [](const std::string&, const std::string& text) { ExpectReadable(text); });
  ros::Time last(100, 0);
  constexpr int kMost = 32;  // fills the longest queue several times; more would only take longer
  for (int i = 0; i < kMost && input.remaining_bytes() > 0; ++i) {
    const int topic = input.ConsumeIntegralInRange(0, 7);
    Add(&synchronizer, topic, ConsumeStamp(&input, &last));
  }
  return 0;
}
