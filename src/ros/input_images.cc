#include "ros/input_images.h"

#include <array>
#include <cstddef>
#include <sstream>
#include <stdexcept>
#include <string>

#include <sensor_msgs/image_encodings.h>

namespace stereo_sgmp {
namespace {

namespace enc = sensor_msgs::image_encodings;

struct Conversion {
  std::string from;
  std::string to;
};

const std::array<Conversion, 6>& Conversions() {
  static const std::array<Conversion, 6> conversions{{{enc::MONO8, enc::MONO8},
                                                      {enc::MONO16, enc::MONO16},
                                                      {enc::BGR8, enc::BGR8},
                                                      {enc::RGB8, enc::BGR8},
                                                      {enc::BGRA8, enc::BGRA8},
                                                      {enc::RGBA8, enc::BGRA8}}};
  return conversions;
}

const std::string& TargetEncoding(const sensor_msgs::Image& message, const char* topic) {
  std::string accepted;
  for (const Conversion& conversion : Conversions()) {
    if (conversion.from == message.encoding) return conversion.to;
    accepted += (accepted.empty() ? "" : ", ") + conversion.from;
  }
  throw std::invalid_argument(std::string(topic) + " has encoding '" + message.encoding +
                              "'; expected one of " + accepted +
                              "; let image_proc debayer and rectify it first");
}

void CheckData(const sensor_msgs::Image& message, const char* topic) {
  const std::size_t bytes_per_pixel = static_cast<std::size_t>(enc::numChannels(message.encoding) *
                                                               enc::bitDepth(message.encoding) / 8);
  const bool filled = message.step >= message.width * bytes_per_pixel &&
                      message.data.size() == std::size_t{message.step} * message.height;
  if (message.width > 0 && message.height > 0 && filled) return;
  std::ostringstream text;
  text << topic << " has " << message.width << " x " << message.height << " pixels, step "
       << message.step << " and " << message.data.size()
       << " bytes; expected at least one pixel and step * height bytes of whole rows; mend its "
          "publisher";
  throw std::invalid_argument(text.str());
}

cv_bridge::CvImageConstPtr ToImage(const sensor_msgs::ImageConstPtr& message, const char* topic,
                                   const std::string& encoding) {
  try {
    return cv_bridge::toCvShare(message, encoding);
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
