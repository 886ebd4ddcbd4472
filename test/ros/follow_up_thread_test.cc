#include "ros/follow_up_thread.h"

#include <array>
#include <atomic>
#include <cstddef>
#include <future>
#include <thread>
#include <utility>
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

// The data of the tests below is plain: it is for the thread to keep its users apart, and for
// ThreadSanitizer to see whether it does.
using Frame = std::vector<int>;

int CountOthers(const Frame& frame, int expected) {
  int others = 0;
  for (const int value : frame) others += value != expected ? 1 : 0;
  return others;
}

TEST(FollowUpThread, TakesTasksFromManyThreads) {
  constexpr int kThreads = 4;
  constexpr int kTasks = 1000;
  std::array<int, kThreads> done{};
  int wrong = 0;
  {
    FollowUpThread thread;
    std::vector<std::thread> starters;
    for (std::size_t k = 0; k < kThreads; ++k) {
      starters.emplace_back([&, k] {
        for (int i = 0; i < kTasks; ++i) {
          thread.Start([&, k, frame = Frame(16, i)] { wrong += CountOthers(frame, done[k]++); });
        }
      });
    }
    for (std::thread& starter : starters) starter.join();
  }
  EXPECT_EQ(wrong, 0);
  EXPECT_THAT(done, testing::Each(kTasks));
}

TEST(FollowUpThread, LeavesTheFrameBeforeTheLastToWhoStartsTasks) {
  std::array<Frame, 2> frames;
  int wrong = 0;
  {
    FollowUpThread thread;
    for (int i = 0; i < 2000; ++i) {
      Frame& frame = frames[static_cast<std::size_t>(i % 2)];
      frame.assign(64, i);
      thread.Start([&wrong, &frame, i] { wrong += CountOthers(frame, i); });
    }
  }
  EXPECT_EQ(wrong, 0);
}

TEST(FollowUpThread, EndsAtAnyMoment) {
  constexpr int kThreads = 300;
  int done = 0;
  for (int i = 0; i < kThreads; ++i) {
    FollowUpThread thread;
    for (int k = 0; k < i % 3; ++k) thread.Start([&done] { ++done; });
  }
  EXPECT_EQ(done, kThreads);
}

}  // namespace
}  // namespace stereo_sgmp
