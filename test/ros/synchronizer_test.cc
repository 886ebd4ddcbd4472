#include "ros/synchronizer.h"

#include <memory>
#include <string>
#include <vector>

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <boost/make_shared.hpp>

namespace stereo_sgmp {
namespace {

using testing::ElementsAre;
using testing::HasSubstr;

class SynchronizerTest : public testing::Test {
 protected:
  static void SetUpTestSuite() { ros::Time::init(); }  // the policies ask for the time

  void Start(const StereoSynchronizer::Settings& settings) {
    synchronizer_ = std::make_unique<StereoSynchronizer>(
        settings,
        [this](const StereoFrame& frame) { frames_.push_back(frame.left->header.stamp.toSec()); },
        [this](const std::string& kind, const std::string& text) {
          kinds_.push_back(kind);
          last_problem_ = text;
        });
  }

  template <class Message>
  static boost::shared_ptr<Message> Stamped(double seconds) {
    auto message = boost::make_shared<Message>();
    message->header.stamp = ros::Time(seconds);
    return message;
  }

  void AddLeft(double seconds) {
    synchronizer_->AddLeftImage(Stamped<sensor_msgs::Image>(seconds));
    synchronizer_->AddLeftInfo(Stamped<sensor_msgs::CameraInfo>(seconds));
  }

  void AddRight(double seconds) {
    synchronizer_->AddRightImage(Stamped<sensor_msgs::Image>(seconds));
    synchronizer_->AddRightInfo(Stamped<sensor_msgs::CameraInfo>(seconds));
  }

  std::unique_ptr<StereoSynchronizer> synchronizer_;
  std::vector<double> frames_;
  std::vector<std::string> kinds_;
  std::string last_problem_;
};

TEST_F(SynchronizerTest, PairsEqualStamps) {
  Start({});
  AddLeft(1.0);
  AddLeft(2.0);
  AddRight(2.0);
  AddLeft(3.0);
  AddRight(3.0);
  EXPECT_THAT(frames_, ElementsAre(2.0, 3.0));
  EXPECT_THAT(kinds_, ElementsAre());
}

TEST_F(SynchronizerTest, PairsAgainAfterTimeWentBack) {
  Start({});
  for (double t : {101.0, 102.0}) {
    AddLeft(t);
    AddRight(t);
  }
  // The right camera stopped first: these wait for partners that never come.
  for (double t : {103.0, 104.0, 105.0, 106.0}) AddLeft(t);
  for (double t : {1.0, 2.0, 3.0}) {
    AddLeft(t);
    AddRight(t);
  }
  EXPECT_THAT(frames_, testing::IsSupersetOf({2.0, 3.0}));
  EXPECT_THAT(kinds_, testing::Each("time"));
  EXPECT_THAT(last_problem_, HasSubstr("went back in time"));
}

TEST_F(SynchronizerTest, ReportsUnequalStamps) {
  Start({});
  for (int i = 0; i < 10; ++i) {
    AddLeft(1.0 + i);
    AddRight(1.25 + i);
  }
  EXPECT_THAT(frames_, ElementsAre());
  EXPECT_THAT(kinds_, ElementsAre("pairing"));
  EXPECT_THAT(last_problem_,
              testing::AllOf(HasSubstr("10.000000000 (left/image_rect)"),
                             HasSubstr("9.250000000 (right/image_rect)"),
                             HasSubstr("expected equal stamps"), HasSubstr("approximate_sync")));
}

TEST_F(SynchronizerTest, ReportsASilentTopic) {
  Start({});
  for (int i = 0; i < 10; ++i) {
    AddLeft(1.0 + i);
    synchronizer_->AddRightImage(Stamped<sensor_msgs::Image>(1.0 + i));
  }
  EXPECT_THAT(last_problem_, HasSubstr("nothing arrives on right/camera_info"));
}

TEST_F(SynchronizerTest, GoesOnAfterStampsThatCantBeCompared) {
  StereoSynchronizer::Settings settings;
  settings.approximate = true;
  Start(settings);
  AddLeft(1.0);
  AddRight(4294967295.0);
  EXPECT_THAT(last_problem_, testing::AllOf(HasSubstr("right/camera_info has the stamp 4294967295"),
                                            HasSubstr("expected one clock for all")));
  for (double t : {2.0, 3.0, 4.0}) {
    AddLeft(t);
    AddRight(t);
  }
  EXPECT_GE(frames_.size(), 1u);
}

TEST_F(SynchronizerTest, PairsNearStampsWhenAsked) {
  StereoSynchronizer::Settings settings;
  settings.approximate = true;
  Start(settings);
  for (int i = 0; i < 10; ++i) {
    AddLeft(1.0 + i);
    AddRight(1.01 + i);
  }
  EXPECT_GE(frames_.size(), 8u);
}

TEST_F(SynchronizerTest, KeepsToTheMaximalInterval) {
  StereoSynchronizer::Settings settings;
  settings.approximate = true;
  settings.max_interval = 0.005;
  Start(settings);
  for (int i = 0; i < 20; ++i) {
    AddLeft(1.0 + i);
    AddRight(1.01 + i);
  }
  EXPECT_THAT(frames_, ElementsAre());
  EXPECT_THAT(last_problem_, HasSubstr("approximate_max_interval (0.005 s)"));
}

}  // namespace
}  // namespace stereo_sgmp
