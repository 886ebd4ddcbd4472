#include "ros/follow_up_thread.h"

#include <atomic>
#include <future>
#include <vector>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace stereo_sgmp {
namespace {

TEST(FollowUpThread, RunsBesideWhoStartsIt) {
  std::promise<void> started;
  std::promise<void> release;
  FollowUpThread thread;
  thread.Start([&] {
    started.set_value();
    release.get_future().wait();
  });
  started.get_future().wait();  // had Start waited for the task, this would never come
  release.set_value();
}

TEST(FollowUpThread, DropsNothingAndKeepsTheOrder) {
  std::vector<int> done;
  {
    FollowUpThread thread;
    for (int i = 0; i < 5; ++i) thread.Start([&done, i] { done.push_back(i); });
  }
  EXPECT_THAT(done, testing::ElementsAre(0, 1, 2, 3, 4));
}

TEST(FollowUpThread, StartsATaskWhenTheOneBeforeHasEnded) {
  std::atomic<bool> ended{false};
  FollowUpThread thread;
  thread.Start([&] { ended = true; });
  thread.Start([] {});
  EXPECT_TRUE(ended);
}

}  // namespace
}  // namespace stereo_sgmp
