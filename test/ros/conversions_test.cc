#include "ros/conversions.h"

#include <cmath>
#include <cstring>
#include <limits>
#include <vector>

#include <gtest/gtest.h>
#include <sensor_msgs/image_encodings.h>

namespace stereo_sgmp {
namespace {

constexpr float kNan = std::numeric_limits<float>::quiet_NaN();

// 4 x 2 pixels, of which (1, 0) and (2, 1) are invalid.
MatchResult MakeResult() {
  MatchResult result;
  result.dense = (cv::Mat_<float>(2, 4) << 10.5f, 11, 12, 13, 14, 15, 16, 17.25f);
  result.reason = (cv::Mat_<std::uint8_t>(2, 4) << 0, 2, 0, 0, 0, 0, 4, 0);
  result.confidence = (cv::Mat_<float>(2, 4) << 0.5f, 0, 1, 1, 1, 1, 1, 0.25f);
  return result;
}

StereoCamera MakeCamera() {
  StereoCamera camera;
  camera.focal_length = 500.0;
  camera.cx = 1.5;
  camera.cy = 0.5;
  camera.doffs = 3.0;  // cx_right - cx_left
  camera.baseline = 0.1;
  return camera;
}

Options MakeOptions() {
  Options options;
  options.min_disparity = 8;
  options.num_disparities = 16;
  return options;
}

std_msgs::Header MakeHeader() {
  std_msgs::Header header;
  header.stamp = ros::Time(12, 34);
  header.frame_id = "left_optical";
  return header;
}

float At(const sensor_msgs::Image& image, std::uint32_t x, std::uint32_t y) {
  float value = 0.0f;
  std::memcpy(&value, image.data.data() + y * image.step + x * sizeof(float), sizeof(float));
  return value;
}

TEST(DisparityImage, IsAdjustedForThePrincipalPoints) {
  const auto message = ToDisparityImage(MakeResult(), MakeOptions(), MakeCamera(), MakeHeader());
  EXPECT_EQ(message->header.stamp, ros::Time(12, 34));
  EXPECT_EQ(message->image.header.frame_id, "left_optical");
  EXPECT_EQ(message->image.encoding, sensor_msgs::image_encodings::TYPE_32FC1);
  EXPECT_EQ(message->image.width, 4u);
  EXPECT_EQ(message->image.height, 2u);
  EXPECT_FLOAT_EQ(message->f, 500.0f);
  EXPECT_FLOAT_EQ(message->T, 0.1f);
  EXPECT_FLOAT_EQ(At(message->image, 0, 0), 13.5f);
  EXPECT_FLOAT_EQ(At(message->image, 3, 1), 20.25f);
}

TEST(DisparityImage, LimitsLieJustOutsideTheValues) {
  const auto message = ToDisparityImage(MakeResult(), MakeOptions(), MakeCamera(), MakeHeader());
  EXPECT_FLOAT_EQ(message->delta_d, 1.0f / 16.0f);
  EXPECT_FLOAT_EQ(message->min_disparity, 8 + 3 - 1.0f / 16);
  EXPECT_FLOAT_EQ(message->max_disparity, 23 + 3 + 1.0f / 16);
  EXPECT_EQ(At(message->image, 1, 0), message->min_disparity - 1);
  EXPECT_EQ(At(message->image, 2, 1), message->min_disparity - 1);
}

TEST(DisparityImage, LimitsFollowValuesBeyondTheSearch) {
  MatchResult result = MakeResult();
  result.dense.at<float>(0, 0) = 7.5f;
  result.dense.at<float>(0, 3) = 23.5f;
  result.dense.at<float>(0, 1) = 100.0f;  // invalid: does not count
  const auto message = ToDisparityImage(result, MakeOptions(), MakeCamera(), MakeHeader());
  EXPECT_LT(message->min_disparity, At(message->image, 0, 0));
  EXPECT_GT(message->max_disparity, At(message->image, 3, 0));
  EXPECT_LT(message->max_disparity, 30.0f);
}

TEST(DisparityImage, WholePixelsHaveAStepOfOne) {
  Options options = MakeOptions();
  options.refinement.subpixel = Subpixel::kNone;
  EXPECT_EQ(ToDisparityImage(MakeResult(), options, MakeCamera(), MakeHeader())->delta_d, 1.0f);
}

TEST(DisparityImage, WindowHoldsThePixelsThatCanMatch) {
  MatchResult result;
  result.dense.create(10, 100, CV_32F);
  result.reason = cv::Mat::zeros(10, 100, CV_8U);
  const auto window = [&](int min_disparity, int num_disparities) {
    Options options;
    options.min_disparity = min_disparity;
    options.num_disparities = num_disparities;
    return ToDisparityImage(result, options, MakeCamera(), MakeHeader())->valid_window;
  };
  EXPECT_EQ(window(0, 64).x_offset, 0u);
  EXPECT_EQ(window(0, 64).width, 100u);
  EXPECT_EQ(window(0, 64).height, 10u);
  EXPECT_EQ(window(8, 16).x_offset, 8u);
  EXPECT_EQ(window(8, 16).width, 92u);
  EXPECT_EQ(window(-30, 11).x_offset, 0u);  // up to -20: the last 20 columns can't match
  EXPECT_EQ(window(-30, 11).width, 80u);
  EXPECT_EQ(window(200, 16).width, 0u);
}

// In place of what a message of another frame left behind.
TEST(PointCloud2, IsFilledRowByRowAsFromAWholeCloud) {
  const MatchResult result = MakeResult();
  cv::Mat image(result.dense.size(), CV_8UC3);
  cv::randu(image, 0, 256);
  PointCloud cloud;
  ComputePointCloud(result, MakeCamera(), image, CloudOptions(), &cloud);
  for (const bool compact : {false, true}) {
    const auto expected = ToPointCloud2(cloud, {compact, false}, MakeHeader());
    sensor_msgs::PointCloud2 message;
    message.data.assign(1000, 0xAB);
    message.is_dense = true;
    FillPointCloud2(CloudRows(result, MakeCamera(), image, CloudOptions()), compact, MakeHeader(),
                    &message);
    EXPECT_EQ(message.width, expected->width);
    EXPECT_EQ(message.height, expected->height);
    EXPECT_EQ(message.row_step, expected->row_step);
    EXPECT_EQ(message.fields, expected->fields);
    EXPECT_FALSE(message.is_dense);
    EXPECT_EQ(message.data, expected->data);
  }
}

TEST(PointCloud2, IsOrganisedAndPacked) {
  PointCloud cloud;
  cloud.width = 2;
  cloud.height = 1;
  cloud.points = {{1, 2, 3, 10, 20, 30, 0, 0.75f}, {kNan, kNan, kNan, 1, 2, 3, 0, 0.0f}};
  const auto message = ToPointCloud2(cloud, CloudLayout(), MakeHeader());
  EXPECT_EQ(message->width, 2u);
  EXPECT_EQ(message->height, 1u);
  EXPECT_EQ(message->point_step, 32u);
  EXPECT_EQ(message->row_step, 64u);
  EXPECT_FALSE(message->is_dense);
  ASSERT_EQ(message->fields.size(), 5u);
  const struct {
    const char* name;
    std::uint32_t offset;
  } expected[] = {{"x", 0}, {"y", 4}, {"z", 8}, {"rgb", 16}, {"confidence", 20}};
  for (std::size_t i = 0; i < message->fields.size(); ++i) {
    EXPECT_EQ(message->fields[i].name, expected[i].name);
    EXPECT_EQ(message->fields[i].offset, expected[i].offset);
    EXPECT_EQ(message->fields[i].datatype, sensor_msgs::PointField::FLOAT32);
  }
  ASSERT_EQ(message->data.size(), 64u);
  float xyz[3];
  std::memcpy(xyz, message->data.data(), sizeof(xyz));
  EXPECT_EQ(xyz[2], 3.0f);
  std::uint32_t rgb = 0;
  std::memcpy(&rgb, message->data.data() + 16, sizeof(rgb));
  EXPECT_EQ(rgb, 0x001E140Au);
  std::memcpy(xyz, message->data.data() + 32, sizeof(xyz));
  EXPECT_TRUE(std::isnan(xyz[0]));
}

TEST(Priors, AreGivenInDisparityAndInSpace) {
  MatchResult result = MakeResult();
  // Disparity 10 everywhere, 13 adjusted: a plane parallel to the image.
  result.priors.planes = {{{0.0, 0.0, 10.0}, 42, 0.5}};
  result.priors.labels = (cv::Mat_<std::int16_t>(1, 2) << 0, -1);
  result.priors.variant = Variant::kEpi;
  const auto message = ToPriors(result.priors, MakeCamera(), MakeHeader());
  EXPECT_EQ(message->variant, "epi");
  ASSERT_EQ(message->planes.size(), 1u);
  const stereo_sgmp::Plane& plane = message->planes[0];
  EXPECT_EQ(plane.c, 10.0);
  EXPECT_NEAR(plane.normal[2], -1.0, 1e-12);
  EXPECT_NEAR(plane.distance, -500.0 * 0.1 / 13.0, 1e-9);
  EXPECT_EQ(plane.support, 42);
  EXPECT_EQ(plane.residual, 0.5);
  EXPECT_EQ(message->labels.encoding, sensor_msgs::image_encodings::TYPE_16SC1);
  EXPECT_EQ(message->labels.width, 2u);
  std::int16_t last = 0;
  std::memcpy(&last, message->labels.data.data() + 2, sizeof(last));
  EXPECT_EQ(last, -1);
}

TEST(Priors, AreEmptyWithoutPrior) {
  const auto message = ToPriors(PlanePriors(), MakeCamera(), MakeHeader());
  EXPECT_EQ(message->variant, "sgm");
  EXPECT_TRUE(message->planes.empty());
  EXPECT_TRUE(message->labels.data.empty());
}

TEST(Statistics, CarryTheCounts) {
  MatchResult result = MakeResult();
  result.statistics.frame_ms = 12.5;
  result.statistics.stages = {{"cost", 5.0}, {"aggregation", 7.5}};
  result.statistics.reasons[2] = 1;
  result.statistics.alignment.offset = 0.5;
  result.priors.variant = Variant::kMw;
  const auto message = ToStatistics(result, MakeHeader());
  EXPECT_EQ(message->variant, "mw");
  EXPECT_EQ(message->frame_ms, 12.5);
  ASSERT_EQ(message->stages.size(), 2u);
  EXPECT_EQ(message->stages[1].name, "aggregation");
  EXPECT_EQ(message->reasons[stereo_sgmp::Statistics::BORDER], 1u);
  EXPECT_EQ(message->alignment_offset, 0.5);
}

TEST(PointCloud2, CompactHasTheSameFieldsWithoutGaps) {
  PointCloud cloud;
  cloud.width = 1;
  cloud.height = 1;
  cloud.points = {{1, 2, 3, 10, 20, 30, 0, 0.75f}};
  const auto message = ToPointCloud2(cloud, {true, true}, MakeHeader());
  EXPECT_EQ(message->point_step, 20u);
  EXPECT_TRUE(message->is_dense);
  ASSERT_EQ(message->data.size(), 20u);
  const std::vector<std::uint32_t> offsets{0, 4, 8, 12, 16};
  ASSERT_EQ(message->fields.size(), offsets.size());
  for (std::size_t i = 0; i < offsets.size(); ++i) {
    EXPECT_EQ(message->fields[i].offset, offsets[i]);
  }
  float confidence = 0.0f;
  std::memcpy(&confidence, message->data.data() + 16, sizeof(confidence));
  EXPECT_EQ(confidence, 0.75f);
  EXPECT_EQ(message->data[14], 30);  // red
}

}  // namespace
}  // namespace stereo_sgmp
