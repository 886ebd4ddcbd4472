#include "ros/worker.h"

#include <future>
#include <vector>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace stereo_sgmp {
namespace {

TEST(NewestItemWorker, DropsWhatWaitsForTheNewest) {
  std::promise<void> first_taken;
  std::promise<void> release;
  std::promise<void> last_done;
  std::vector<int> done;
  NewestItemWorker<int> worker([&](const int& item) {
    if (item == 1) {
      first_taken.set_value();
      release.get_future().wait();
    }
    done.push_back(item);
    if (item == 4) last_done.set_value();
  });
  worker.Offer(1);
  first_taken.get_future().wait();
  for (int item : {2, 3, 4}) worker.Offer(item);
  EXPECT_EQ(worker.dropped(), 2u);
  release.set_value();
  last_done.get_future().wait();
  EXPECT_THAT(done, testing::ElementsAre(1, 4));
}

TEST(NewestItemWorker, ForgetsWhatWaits) {
  std::promise<void> taken;
  std::promise<void> release;
  std::vector<int> done;
  {
    NewestItemWorker<int> worker([&](const int& item) {
      taken.set_value();
      release.get_future().wait();
      done.push_back(item);
    });
    worker.Offer(1);
    taken.get_future().wait();
    worker.Offer(2);
    worker.Clear();
    release.set_value();
  }
  EXPECT_THAT(done, testing::ElementsAre(1));
}

TEST(NewestItemWorker, WorksNoMoreOnceStopped) {
  int done = 0;
  NewestItemWorker<int> worker([&](const int&) { ++done; });
  worker.Stop();
  worker.Offer(1);
  worker.Stop();
  EXPECT_EQ(done, 0);
}

TEST(NewestItemWorker, StopsWithoutWork) {
  NewestItemWorker<int> worker([](const int&) {});
}

}  // namespace
}  // namespace stereo_sgmp
