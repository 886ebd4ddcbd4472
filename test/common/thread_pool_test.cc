#include "common/thread_pool.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <sched.h>

#include <atomic>
#include <chrono>
#include <cstddef>
#include <ctime>
#include <set>
#include <stdexcept>
#include <thread>
#include <vector>

namespace stereo_sgmp {
namespace {

// The cores that the calling thread may run on.
std::set<int> UsableCores() {
  cpu_set_t usable;
  EXPECT_EQ(sched_getaffinity(0, sizeof(usable), &usable), 0);
  std::set<int> cores;
  for (int core = 0; core < CPU_SETSIZE; ++core) {
    if (CPU_ISSET(core, &usable)) cores.insert(core);
  }
  return cores;
}

TEST(ThreadPoolTest, RunsEachPartOnAThreadOfItsOwn) {
  ThreadPool pool(3);
  EXPECT_EQ(pool.size(), 3);
  std::vector<std::thread::id> ids(3);
  for (int round = 0; round < 100; ++round) {
    pool.Run([&](int i) { ids[static_cast<std::size_t>(i)] = std::this_thread::get_id(); });
    EXPECT_EQ(ids[0], std::this_thread::get_id());
    EXPECT_EQ(std::set<std::thread::id>(ids.begin(), ids.end()).size(), 3U);
  }
}

TEST(ThreadPoolTest, RangesCoverTheCountOnce) {
  ThreadPool pool(4);
  for (const int count : {0, 1, 3, 4, 5, 1000}) {
    std::vector<std::atomic<int>> visits(static_cast<std::size_t>(count));
    pool.ForRanges(count, [&](int begin, int end) {
      for (int i = begin; i < end; ++i) ++visits[static_cast<std::size_t>(i)];
    });
    for (const std::atomic<int>& visit : visits) EXPECT_EQ(visit, 1) << count;
  }
}

TEST(ThreadPoolTest, PiecesCoverTheCountOnceAndAThreadDoesOneAtATime) {
  ThreadPool pool(3);
  for (const int size : {1, 4, 7, 100}) {
    std::vector<std::atomic<int>> visits(50);
    std::vector<std::atomic<bool>> busy(3);
    pool.ForPieces(50, size, [&](int thread, int begin, int end) {
      EXPECT_FALSE(busy[static_cast<std::size_t>(thread)].exchange(true));
      EXPECT_EQ(begin % size, 0);
      EXPECT_LE(end - begin, size);
      for (int i = begin; i < end; ++i) ++visits[static_cast<std::size_t>(i)];
      busy[static_cast<std::size_t>(thread)] = false;
    });
    for (const std::atomic<int>& visit : visits) EXPECT_EQ(visit, 1) << size;
  }
}

TEST(ThreadPoolTest, ASlowPieceHoldsNoOtherUp) {
  ThreadPool pool(2);
  std::atomic<int> done{0};
  pool.ForPieces(10, 1, [&](int, int piece, int) {
    const auto end = std::chrono::steady_clock::now() + std::chrono::seconds(20);
    while (piece == 0 && done < 9 && std::chrono::steady_clock::now() < end) {
      std::this_thread::yield();
    }
    EXPECT_TRUE(piece != 0 || done == 9);
    ++done;
  });
  EXPECT_EQ(done, 10);
}

TEST(ThreadPoolTest, ASharedTaskWaitsForThoseThatHaveBegunAlone) {
  ThreadPool pool(3);
  for (int round = 0; round < 2000; ++round) {
    std::atomic<int> begun{0};
    std::atomic<int> ended{0};
    pool.Share([&](int) {
      ++begun;
      ++ended;
    });
    const int in_time = begun;
    EXPECT_GE(in_time, 1);
    EXPECT_LE(in_time, 3);
    EXPECT_EQ(ended, in_time);
    std::atomic<int> parts{0};
    if (round % 16 == 0) pool.Run([&](int) { ++parts; });
    EXPECT_EQ(parts, round % 16 == 0 ? 3 : 0);
    EXPECT_EQ(begun, in_time) << "a late one began after all";
  }
}

TEST(ThreadPoolTest, PassesAnExceptionOnAndGoesOn) {
  ThreadPool pool(2);
  for (const int thrower : {0, 1}) {
    EXPECT_THROW(pool.Run([&](int i) {
      if (i == thrower) throw std::runtime_error("as wanted");
    }),
                 std::runtime_error);
    EXPECT_THROW(pool.Share([](int) { throw std::runtime_error("as wanted"); }),
                 std::runtime_error);
    std::atomic<int> parts{0};
    pool.Run([&](int) { ++parts; });
    EXPECT_EQ(parts, 2);
  }
}

TEST(ThreadPoolTest, JobsFollowThoseTheyWaitFor) {
  for (const int threads : {1, 2, 4}) {
    ThreadPool pool(threads);
    for (int round = 0; round < 50; ++round) {
      std::atomic<int> clock{0};
      std::vector<int> begun(5, -1);
      std::vector<int> done(5, -1);
      std::vector<ThreadPool::Job> jobs;
      const std::vector<std::vector<std::size_t>> after = {{}, {}, {0}, {0, 1}, {3}};
      for (std::size_t i = 0; i < after.size(); ++i) {
        jobs.push_back({[&, i] {
                          begun[i] = clock++;
                          done[i] = clock++;
                        },
                        after[i]});
      }
      pool.RunJobs(jobs);
      EXPECT_EQ(clock, 10);
      for (std::size_t i = 0; i < after.size(); ++i) {
        for (const std::size_t first : after[i]) EXPECT_LT(done[first], begun[i]);
      }
    }
  }
}

TEST(ThreadPoolTest, JobsRunSideBySide) {
  ThreadPool pool(2);
  std::atomic<bool> met{false};
  const auto wait = [&] {
    const auto end = std::chrono::steady_clock::now() + std::chrono::seconds(20);
    while (!met && std::chrono::steady_clock::now() < end) std::this_thread::yield();
  };
  pool.RunJobs({{wait, {}}, {[&] { met = true; }, {}}});
  EXPECT_TRUE(met);
}

TEST(ThreadPoolTest, JobsAfterOneThatThrowsAreLeft) {
  for (const int threads : {1, 2, 3}) {
    ThreadPool pool(threads);
    std::atomic<bool> followed{false};
    const std::vector<ThreadPool::Job> jobs = {{[] { throw std::runtime_error("as wanted"); }, {}},
                                               {[&] { followed = true; }, {0}}};
    EXPECT_THROW(pool.RunJobs(jobs), std::runtime_error);
    EXPECT_FALSE(followed);
    pool.RunJobs({{[&] { followed = true; }, {}}});
    EXPECT_TRUE(followed);
  }
}

TEST(ThreadPoolTest, ZeroTakesTheCoresOfTheProcess) {
  EXPECT_EQ(ThreadPool::Count(0), static_cast<int>(UsableCores().size()));
  EXPECT_EQ(ThreadPool::Count(5), 5);
}

TEST(ThreadPoolTest, PinnedThreadsKeepToOneCoreEachAndTheCallerToNone) {
  const std::set<int> all = UsableCores();
  ThreadPool pool(0, true);
  std::vector<std::set<int>> cores(static_cast<std::size_t>(pool.size()));
  pool.Run([&](int i) { cores[static_cast<std::size_t>(i)] = UsableCores(); });
  EXPECT_EQ(cores[0], all);
  std::set<int> taken;
  for (std::size_t i = 1; i < cores.size(); ++i) {
    ASSERT_EQ(cores[i].size(), 1U);
    taken.insert(*cores[i].begin());
  }
  EXPECT_EQ(taken.size(), cores.size() - 1);
  EXPECT_THAT(taken, ::testing::IsSubsetOf(all));
}

TEST(ThreadPoolTest, IdleThreadsTakeNoTime) {
  ThreadPool pool(4);
  pool.Run([](int) {});
  const std::clock_t before = std::clock();  // of all threads
  std::this_thread::sleep_for(std::chrono::milliseconds(200));
  EXPECT_LT(std::clock() - before, CLOCKS_PER_SEC / 100);
}

}  // namespace
}  // namespace stereo_sgmp
