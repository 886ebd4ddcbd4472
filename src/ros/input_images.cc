#include "ros/input_images.h"

#include <array>
#include <cstddef>
#include <sstream>
#include <stdexcept>
#include <string>
#include <utility>

#include <sensor_msgs/image_encodings.h>
#include <boost/make_shared.hpp>

#include "common/excerpt.h"

namespace stereo_sgmp {
namespace {

namespace enc = sensor_msgs::image_encodings;

struct Conversion {
  std::string from;
  std::string to;
};

const std::array<Conversion, 6>& Conversions() {
  static const std::array<Conversion, 6> kConversions{{{enc::MONO8, enc::MONO8},
                                                       {enc::MONO16, enc::MONO16},
                                                       {enc::BGR8, enc::BGR8},
                                                       {enc::RGB8, enc::BGR8},
                                                       {enc::BGRA8, enc::BGRA8},
                                                       {enc::RGBA8, enc::BGRA8}}};
  return kConversions;
}

const std::string& TargetEncoding(const sensor_msgs::Image& message, const char* topic) {
  std::string accepted;
  for (const Conversion& conversion : Conversions()) {
    if (conversion.from == message.encoding) return conversion.to;
    accepted += (accepted.empty() ? "" : ", ") + conversion.from;
  }
  throw std::invalid_argument(std::string(topic) + " has encoding '" + Excerpt(message.encoding) +
                              "'; expected one of " + accepted +
                              "; let image_proc debayer and rectify it first");
}

void CheckData(const sensor_msgs::Image& message, const char* topic) {
  const auto bytes_per_sample = static_cast<std::size_t>(enc::bitDepth(message.encoding) / 8);
  const std::size_t bytes_per_pixel =
      static_cast<std::size_t>(enc::numChannels(message.encoding)) * bytes_per_sample;
  const bool filled = message.step >= message.width * bytes_per_pixel &&
                      message.step % bytes_per_sample == 0 &&
                      message.data.size() == std::size_t{message.step} * message.height;
  if (message.width > 0 && message.height > 0 && filled) return;
  std::ostringstream text;
  text << topic << " has " << message.width << " x " << message.height << " pixels, step "
       << message.step << " and " << message.data.size()
       << " bytes; expected at least one pixel and step * height bytes of whole rows; mend its "
          "publisher";
  throw std::invalid_argument(text.str());
}

// The message itself, or a copy whose samples are little-endian as this machine's: cv_bridge makes
// images of two channels of the others.
sensor_msgs::ImageConstPtr InLittleEndian(const sensor_msgs::ImageConstPtr& message) {
  static_assert(__BYTE_ORDER__ == __ORDER_LITTLE_ENDIAN__, "the machine's order");
  if (message->is_bigendian == 0 || enc::bitDepth(message->encoding) != 16) return message;
  const auto swapped = boost::make_shared<sensor_msgs::Image>(*message);
  swapped->is_bigendian = 0;
  for (std::size_t i = 0; i + 1 < swapped->data.size(); i += 2) {
    std::swap(swapped->data[i], swapped->data[i + 1]);
  }
  return swapped;
}

cv_bridge::CvImageConstPtr ToImage(const sensor_msgs::ImageConstPtr& message, const char* topic,
                                   const std::string& encoding) {
  try {
    return cv_bridge::toCvShare(InLittleEndian(message), encoding);
  } catch (const cv_bridge::Exception& error) {
    throw std::invalid_argument(std::string(topic) + " can't be converted from " +
                                message->encoding + " to " + encoding + ": " + error.what());
  }
}

}  // namespace

cv_bridge::CvImageConstPtr ToImage(const sensor_msgs::ImageConstPtr& message, const char* topic) {
  const std::string& encoding = TargetEncoding(*message, topic);
  CheckData(*message, topic);
  return ToImage(message, topic, encoding);
}

InputPair ToInputPair(const sensor_msgs::ImageConstPtr& left,
                      const sensor_msgs::ImageConstPtr& right) {
  InputPair pair{ToImage(left, "left/image_rect"), ToImage(right, "right/image_rect")};
  if (left->width != right->width || left->height != right->height) {
    std::ostringstream text;
    text << "left/image_rect is of " << left->width << " x " << left->height
         << " pixels, right/image_rect of " << right->width << " x " << right->height
         << "; expected one size; set both cameras to the same resolution";
    throw std::invalid_argument(text.str());
  }
  if (pair.left->encoding != pair.right->encoding) {
    pair.left = ToImage(left, "left/image_rect", enc::MONO8);
    pair.right = ToImage(right, "right/image_rect", enc::MONO8);
  }
  return pair;
}

}  // namespace stereo_sgmp
