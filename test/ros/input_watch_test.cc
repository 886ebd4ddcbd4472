#include "ros/input_watch.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace stereo_sgmp {
namespace {

using testing::HasSubstr;
using testing::Not;

const char kImage[] = "sensor_msgs/Image";
const char kInfo[] = "sensor_msgs/CameraInfo";

std::string Advice(const InputTopic& input, const std::vector<PublishedTopic>& published) {
  return SilenceAdvice({input}, published);
}

TEST(SilenceAdviceTest, NamesTopicsOfTheSameKind) {
  const std::string advice =
      Advice({"/stereo/left/image_rect", kImage, 0, 0}, {{"/front/left/image_rect", kImage},
                                                         {"/front/left/camera_info", kInfo},
                                                         {"/front/left/image_mono", kImage}});
  EXPECT_THAT(advice, HasSubstr("of its type there are /front/left/image_rect: set left:="));
  EXPECT_THAT(advice, Not(HasSubstr("image_mono")));
}

TEST(SilenceAdviceTest, NamesTheRawImageThatIsNotRectified) {
  EXPECT_THAT(Advice({"/stereo/left/image_rect", kImage, 0, 0},
                     {{"/stereo/left/image_raw", kImage}, {"/a/left/image_rect", kImage}}),
              HasSubstr("there is /stereo/left/image_raw: rectify it"));
}

TEST(SilenceAdviceTest, TellsAPublisherThatIsSilent) {
  EXPECT_THAT(Advice({"/stereo/left/camera_info", kInfo, 7, 1}, {}),
              HasSubstr("/stereo/left/camera_info (7 messages): its publisher is connected but "
                        "sends nothing"));
}

TEST(SilenceAdviceTest, SaysWhenThereIsNothingAtAll) {
  EXPECT_THAT(Advice({"/stereo/left/image_rect", kImage, 0, 0}, {{"/rosout", "rosgraph_msgs/Log"}}),
              HasSubstr("nobody publishes it, nor any other sensor_msgs/Image"));
}

TEST(InputWatchTest, IsSilentAfterAWhileWithoutMessages) {
  InputWatch watch;
  std::vector<InputTopic> inputs{{"/left", kImage, 0, 1}};
  EXPECT_FALSE(watch.IsSilent(inputs, ros::WallTime(100.0)));
  EXPECT_FALSE(watch.IsSilent(inputs, ros::WallTime(104.0)));
  EXPECT_TRUE(watch.IsSilent(inputs, ros::WallTime(106.0)));
  EXPECT_FALSE(watch.IsSilent(inputs, ros::WallTime(107.0)));
  inputs[0].received = 1;
  EXPECT_FALSE(watch.IsSilent(inputs, ros::WallTime(112.0)));
  EXPECT_TRUE(watch.IsSilent(inputs, ros::WallTime(118.0)));
  watch.Reset();
  EXPECT_FALSE(watch.IsSilent(inputs, ros::WallTime(130.0)));
}

}  // namespace
}  // namespace stereo_sgmp
