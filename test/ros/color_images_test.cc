#include "ros/color_images.h"

#include <boost/make_shared.hpp>

#include <gtest/gtest.h>

#include <chrono>
#include <thread>

namespace stereo_sgmp {
namespace {

using std::chrono::milliseconds;

sensor_msgs::ImageConstPtr ImageOf(double stamp) {
  auto image = boost::make_shared<sensor_msgs::Image>();
  image->header.stamp = ros::Time(stamp);
  return image;
}

// For what must not be waited for; a test that does fails by its time.
constexpr milliseconds kForever(600'000);

TEST(ColorImagesTest, FindsTheLatestOfItsStamp) {
  ColorImages images(3);
  EXPECT_EQ(images.Find(ros::Time(1.0)), nullptr);
  const auto first = ImageOf(1.0);
  const auto again = ImageOf(1.0);
  images.Add(first);
  EXPECT_EQ(images.Find(ros::Time(1.0)), first);
  images.Add(again);
  EXPECT_EQ(images.Find(ros::Time(1.0)), again);
  for (const double stamp : {2.0, 3.0, 4.0}) images.Add(ImageOf(stamp));
  EXPECT_EQ(images.Find(ros::Time(1.0)), nullptr);
}

TEST(ColorImagesTest, WaitsForOneThatIsLate) {
  ColorImages images(3);
  images.Add(ImageOf(1.0));
  const auto late = ImageOf(1.1);
  std::thread camera([&] {
    std::this_thread::sleep_for(milliseconds(20));
    images.Add(late);
  });
  EXPECT_EQ(images.WaitFor(ros::Time(1.1), kForever), late);
  camera.join();
}

TEST(ColorImagesTest, WaitsNoLongerThanItIsTo) {
  ColorImages images(3);
  images.Add(ImageOf(1.0));
  EXPECT_EQ(images.WaitFor(ros::Time(1.1), milliseconds(5)), nullptr);
}

TEST(ColorImagesTest, WaitsForNoneThatIsLost) {
  ColorImages images(3);
  images.Add(ImageOf(1.0));
  std::thread camera([&] {
    std::this_thread::sleep_for(milliseconds(20));
    images.Add(ImageOf(1.2));
  });
  EXPECT_EQ(images.WaitFor(ros::Time(1.1), kForever), nullptr);
  camera.join();
}

TEST(ColorImagesTest, WaitsForNoneWhereNoneCome) {
  ColorImages images(3);
  EXPECT_EQ(images.WaitFor(ros::Time(1.0), kForever), nullptr);
  images.Add(ImageOf(1.0));
  EXPECT_EQ(images.WaitFor(ros::Time(2.5), kForever), nullptr);
  // Far apart, as when a clock jumps.
  EXPECT_EQ(images.WaitFor(ros::Time(4.0e9), kForever), nullptr);
}

}  // namespace
}  // namespace stereo_sgmp
