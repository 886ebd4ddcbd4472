#include "common/core_spread.h"

#include <gtest/gtest.h>
#include <pthread.h>
#include <sched.h>

#include <atomic>
#include <chrono>
#include <future>
#include <optional>
#include <thread>
#include <vector>

namespace stereo_sgmp {
namespace {

cpu_set_t Usable() {
  cpu_set_t usable;
  EXPECT_EQ(sched_getaffinity(0, sizeof(usable), &usable), 0);
  return usable;
}

void Allow(const cpu_set_t& cores) { ASSERT_EQ(sched_setaffinity(0, sizeof(cores), &cores), 0); }

cpu_set_t Only(int core) {
  cpu_set_t only;
  CPU_ZERO(&only);
  CPU_SET(core, &only);
  return only;
}

TEST(CoreSpreadTest, MovesAwayFromTheCoreOfAnotherThread) {
  const cpu_set_t usable = Usable();
  if (CPU_COUNT(&usable) < 2) GTEST_SKIP() << "on one core there is nowhere to move to";
  for (int core = 0; core < CPU_SETSIZE; ++core) {
    if (!CPU_ISSET(core, &usable)) continue;
    CoreSpread spread(2);
    Allow(Only(core));
    spread.Begin(0);
    Allow(usable);
    spread.MoveApart(1);
    const cpu_set_t after = Usable();
    EXPECT_TRUE(CPU_EQUAL(&after, &usable));
    // Stays there until the scheduler has a reason of its own.
    EXPECT_NE(sched_getcpu(), core);
  }
}

TEST(CoreSpreadTest, StaysWhereAllCoresAreTaken) {
  const cpu_set_t usable = Usable();
  CoreSpread spread(3);
  Allow(Only(sched_getcpu()));
  const cpu_set_t only = Usable();
  spread.Begin(0);
  spread.MoveApart(1);
  const cpu_set_t after = Usable();
  EXPECT_TRUE(CPU_EQUAL(&after, &only));
  Allow(usable);
}

// The first one is the caller's, whose affinity is not this library's matter.
TEST(CoreSpreadTest, NeverMovesTheFirstThread) {
  const cpu_set_t usable = Usable();
  CoreSpread spread(2);
  Allow(Only(sched_getcpu()));
  const int core = sched_getcpu();
  spread.Begin(1);
  Allow(usable);
  spread.MoveApart(0);
  EXPECT_EQ(sched_getcpu(), core);
}

// Spins on a core of its own choice until it is told to stop.
class Spinner {
 public:
  Spinner(CoreSpread* spread, int index, const cpu_set_t& cores)
      : thread_([this, spread, index, cores] {
          Allow(cores);
          if (spread != nullptr) spread->Begin(index);
          runs_ = true;
          while (!stop_) core_ = sched_getcpu();
          if (spread != nullptr) spread->Rest(index);
        }) {
    while (!runs_) std::this_thread::yield();
  }
  ~Spinner() {
    stop_ = true;
    thread_.join();
  }

  int core() const { return core_; }
  cpu_set_t Cores() {
    cpu_set_t cores;
    EXPECT_EQ(pthread_getaffinity_np(thread_.native_handle(), sizeof(cores), &cores), 0);
    return cores;
  }
  void AllowAll(const cpu_set_t& cores) {
    ASSERT_EQ(pthread_setaffinity_np(thread_.native_handle(), sizeof(cores), &cores), 0);
  }

 private:
  std::atomic<bool> runs_{false};
  std::atomic<bool> stop_{false};
  std::atomic<int> core_{-1};
  std::thread thread_;
};

// Whether LendCore lends within `time`, asked all the time: so the scheduler sees no free core.
bool LendsWithin(std::chrono::milliseconds time, CoreSpread* spread, int index) {
  const auto end = std::chrono::steady_clock::now() + time;
  while (std::chrono::steady_clock::now() < end) {
    if (spread->LendCore(index)) return true;
  }
  return false;
}

// The test's thread 0 has one core for itself; another program has the other.
class CoreLendingTest : public testing::Test {
 protected:
  void SetUp() override {
    for (int core = 0; core < CPU_SETSIZE; ++core) {
      if (CPU_ISSET(core, &usable_)) cores_.push_back(core);
    }
    if (cores_.size() < 2) GTEST_SKIP() << "on one core there is none to lend";
    Allow(Only(cores_[0]));
    program_.emplace(nullptr, 0, Only(cores_[1]));
  }
  void TearDown() override { Allow(usable_); }

  const cpu_set_t usable_ = Usable();
  std::vector<int> cores_;
  std::optional<Spinner> program_;
  CoreSpread spread_{2};
};

TEST_F(CoreLendingTest, LendsToAThreadThatHasLostItsOwn) {
  Spinner worker(&spread_, 1, Only(cores_[1]));
  worker.AllowAll(usable_);
  EXPECT_TRUE(LendsWithin(std::chrono::seconds(5), &spread_, 0));
  std::this_thread::sleep_for(std::chrono::milliseconds(5));
  EXPECT_EQ(worker.core(), cores_[0]);
  const cpu_set_t after = worker.Cores();
  EXPECT_TRUE(CPU_EQUAL(&after, &usable_));  // free to run on all of them
}

TEST_F(CoreLendingTest, LendsNothingToAThreadThatMayNotRunThere) {
  const Spinner worker(&spread_, 1, Only(cores_[1]));
  EXPECT_FALSE(LendsWithin(std::chrono::milliseconds(100), &spread_, 0));
  EXPECT_EQ(worker.core(), cores_[1]);
}

TEST_F(CoreLendingTest, LendsNothingToAThreadThatSleepsByItsOwnWill) {
  for (const bool rests : {true, false}) {
    std::promise<void> begun;
    std::promise<void> stop;
    std::thread sleeper([&] {
      Allow(usable_);
      spread_.Begin(1);
      if (rests) spread_.Rest(1);
      begun.set_value();
      stop.get_future().wait();
      spread_.Rest(1);
    });
    begun.get_future().wait();
    // One that has not said so looks like one without a core.
    const std::chrono::milliseconds time(rests ? 20 : 5000);
    EXPECT_EQ(LendsWithin(time, &spread_, 0), !rests);
    stop.set_value();
    sleeper.join();
  }
}

}  // namespace
}  // namespace stereo_sgmp
