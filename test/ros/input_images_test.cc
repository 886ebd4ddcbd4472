#include "ros/input_images.h"

#include <stdexcept>
#include <string>

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <sensor_msgs/image_encodings.h>
#include <boost/make_shared.hpp>

namespace stereo_sgmp {
namespace {

namespace enc = sensor_msgs::image_encodings;
using testing::HasSubstr;

sensor_msgs::ImagePtr Image(const std::string& encoding, unsigned width, unsigned height) {
  auto image = boost::make_shared<sensor_msgs::Image>();
  image->encoding = encoding;
  image->width = width;
  image->height = height;
  image->step =
      width * static_cast<unsigned>(enc::numChannels(encoding) * enc::bitDepth(encoding) / 8);
  image->data.assign(image->step * height, 0);
  return image;
}

std::string Refusal(const sensor_msgs::ImageConstPtr& left,
                    const sensor_msgs::ImageConstPtr& right) {
  try {
    ToInputPair(left, right);
  } catch (const std::invalid_argument& error) {
    return error.what();
  }
  return "";
}

TEST(ToImage, TakesGrayAndColour) {
  const struct {
    std::string encoding;
    int type;
  } cases[] = {{enc::MONO8, CV_8UC1}, {enc::MONO16, CV_16UC1}, {enc::BGR8, CV_8UC3},
               {enc::RGB8, CV_8UC3},  {enc::BGRA8, CV_8UC4},   {enc::RGBA8, CV_8UC4}};
  for (const auto& [encoding, type] : cases) {
    EXPECT_EQ(ToImage(Image(encoding, 5, 3), "left/image_rect")->image.type(), type) << encoding;
  }
}

TEST(ToImage, BringsColoursInOpenCvsOrder) {
  const sensor_msgs::ImagePtr image = Image(enc::RGB8, 1, 1);
  image->data = {1, 2, 3};
  EXPECT_EQ(ToImage(image, "left/image_rect")->image.at<cv::Vec3b>(0, 0), cv::Vec3b(3, 2, 1));
}

TEST(ToImage, TakesBothByteOrders) {
  const sensor_msgs::ImagePtr image = Image(enc::MONO16, 1, 2);
  image->is_bigendian = 1;
  image->data = {1, 2, 3, 4};
  const cv_bridge::CvImageConstPtr converted = ToImage(image, "left/image_rect");
  const cv::Mat& pixels = converted->image;
  ASSERT_EQ(pixels.type(), CV_16UC1);
  EXPECT_EQ(pixels.at<std::uint16_t>(0, 0), 0x0102);
  EXPECT_EQ(pixels.at<std::uint16_t>(1, 0), 0x0304);
}

TEST(ToInputPair, SharesThePixels) {
  const sensor_msgs::ImagePtr image = Image(enc::MONO8, 5, 3);
  EXPECT_EQ(ToInputPair(image, image).left->image.data, image->data.data());
}

TEST(ToInputPair, MakesOneTypeOfTwo) {
  const InputPair pair = ToInputPair(Image(enc::BGR8, 5, 3), Image(enc::MONO16, 5, 3));
  EXPECT_EQ(pair.left->image.type(), CV_8UC1);
  EXPECT_EQ(pair.right->image.type(), CV_8UC1);
}

TEST(ToInputPair, RefusesOtherEncodings) {
  EXPECT_THAT(Refusal(Image(enc::MONO8, 5, 3), Image(enc::BAYER_RGGB8, 5, 3)),
              testing::AllOf(HasSubstr("right/image_rect has encoding 'bayer_rggb8'"),
                             HasSubstr("mono8, mono16, bgr8, rgb8, bgra8, rgba8")));
  const sensor_msgs::ImagePtr strange = Image(enc::MONO8, 5, 3);
  strange->encoding = "no such thing";
  EXPECT_THAT(Refusal(strange, strange), HasSubstr("'no such thing'"));
}

TEST(ToInputPair, RefusesUnequalSizes) {
  EXPECT_THAT(Refusal(Image(enc::MONO8, 5, 3), Image(enc::MONO8, 6, 3)),
              HasSubstr("left/image_rect is of 5 x 3 pixels, right/image_rect of 6 x 3"));
}

TEST(ToInputPair, RefusesMissingData) {
  const sensor_msgs::ImagePtr good = Image(enc::MONO8, 5, 3);
  const sensor_msgs::ImagePtr truncated = Image(enc::MONO8, 5, 3);
  truncated->data.pop_back();
  EXPECT_THAT(Refusal(truncated, good), HasSubstr("14 bytes"));
  const sensor_msgs::ImagePtr narrow = Image(enc::MONO8, 5, 3);
  narrow->step = 4;
  narrow->data.resize(12);
  EXPECT_THAT(Refusal(good, narrow), HasSubstr("step 4"));
  EXPECT_THAT(Refusal(Image(enc::MONO8, 0, 3), good), HasSubstr("0 x 3 pixels"));
  const sensor_msgs::ImagePtr odd = Image(enc::MONO16, 5, 3);
  odd->step = 11;
  odd->data.resize(33);
  EXPECT_THAT(Refusal(odd, good), HasSubstr("step 11"));
}

}  // namespace
}  // namespace stereo_sgmp
